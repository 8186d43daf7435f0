// Waves told from an anchor near the eye: phases in single precision are lost a few kilometres from where a wave comes
// from, so the host works out in double precision the phase and the arc at the anchor, and what is left is small. Lengths in
// planet radii.
#include "lib/half_angles.glsl"
#include "lib/waves.glsl"

// One wave as the anchor sees it. outward, aside: unit tangents at the anchor, away from the wave's origin and to the side
// (anchor x outward); cosine, sine: of the arc from the origin to the anchor.
struct AnchoredWave {
  vec3 outward;
  vec3 aside;
  float cosine;
  float sine;
  float amplitude;
  float wavenumber;  // rad per radian of arc
  float phase;       // at the anchor, reduced to one turn
  float pinch;       // Q A
};

// Adds one wave at v, the direction of anchor + offset, whose tangents are frame. fade_from, fade_to: the pinch fades in
// as 1 - |cos| of the arc from the origin grows from the one to the other (Michelic 2018, 11); fade_from = fade_to: not at
// all. At the origin and its antipode itself the wave has no direction and does not pinch.
void add_anchored_wave(inout WaveSum sum, vec3 v, Frame frame, vec3 anchor, vec3 offset, AnchoredWave wave,
                       float fade_from, float fade_to) {
  // The place along anchor, outward and aside.
  float up = 1.0 + dot(offset, anchor);
  float out_by = dot(offset, wave.outward);
  float side = dot(offset, wave.aside);
  float size = sqrt(up * up + out_by * out_by + side * side);
  // Its parts along the wave's axis and across it; the gain of the second by the side is no difference of near numbers.
  float along = up * wave.cosine - out_by * wave.sine;
  float ahead = up * wave.sine + out_by * wave.cosine;
  float across = sqrt(ahead * ahead + side * side);
  float gain = ahead > 0.0 ? side * side / (ahead + across) : across - ahead;
  float arc_gain = angle_of(out_by + wave.cosine * gain, up + wave.sine * gain);
  vec2 turn = cos_sin(wave.phase + wave.wavenumber * arc_gain);

  float per_across = across > 0.0 ? 1.0 / across : 0.0;
  vec3 e = per_across * (ahead * wave.aside - side * (wave.sine * anchor + wave.cosine * wave.outward));
  vec3 direction = cross(e, v);
  vec2 d = along_axes(direction, frame);
  float sine = across / size;
  float cosine = along / size;

  float fade = 1.0;
  float fade_slope = 0.0;
  if (fade_to > fade_from) {
    float x = (sine * sine / (1.0 + abs(cosine)) - fade_from) / (fade_to - fade_from);
    x = clamp(x, 0.0, 1.0);
    fade = x * x * (3.0 - 2.0 * x);
    fade_slope = 6.0 * x * (1.0 - x) / (fade_to - fade_from) * (cosine < 0.0 ? -sine : sine);
  }
  float pinch = across > 0.0 ? fade * wave.pinch : 0.0;
  float sway = pinch * turn.x;
  float rise = wave.amplitude * wave.wavenumber * turn.x;
  float stretch_along = fade_slope * wave.pinch * turn.x - pinch * wave.wavenumber * turn.y;
  float stretch_across = sway * along * per_across;
  add_swell(sum, d, wave.amplitude * turn.y, rise, sway, stretch_along, stretch_across,
            vec2(wave.amplitude, -wave.pinch * wave.wavenumber) * turn.x);
}
