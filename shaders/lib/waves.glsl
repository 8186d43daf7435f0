// Trochoidal waves on a sphere (Sandahl 2022, equations 14 to 16; Michelic 2018, 7 to 11), in planet radii, on the unit
// sphere. Directions are unit tangents, which the printed (15) is not, and the normal is exact, which (16) is not.
#include "lib/angles.glsl"
#include "lib/tangent.glsl"

struct Wave {
  vec3 origin;       // unit vector to the place that the wave comes from
  float amplitude;   // A
  float wavenumber;  // w, rad per radian of arc
  float phase;       // phi t, reduced to one turn
  float pinch;       // Q A: how far water moves to and fro
};

// A tangent frame at v: east x north = v.
struct Frame {
  vec3 east;
  vec3 north;
};

// A vector told along the axes of a frame.
vec2 along_axes(vec3 v, Frame f) { return vec2(dot(v, f.east), dot(v, f.north)); }

// Any tangent frame does; this one has no pole.
Frame frame_at(vec3 v) {
  Frame f;
  f.east = perpendicular(v);
  f.north = cross(v, f.east);
  return f;
}

// How much of a wave samples a footprint (rad) apart can show, 0..1: all of it from four a wavelength on, none below two.
float wave_weight(float wavenumber, float footprint) {
  float x = clamp(0.6366197723675814 * wavenumber * footprint - 1.0, 0.0, 1.0);
  return 1.0 - x * x * (3.0 - 2.0 * x);
}

// The sum of waves at a place, told in its frame; slopes and stretches are per radian of arc.
struct WaveSum {
  float height;          // along v
  float before;          // the height a quarter of each wave's period before
  float stretch_before;  // the same of what stretches water along each wave's way
  vec2 shift;            // along east, north
  vec2 slope;            // d height
  float stretch_ee;      // d shift.x along east
  float stretch_en;      // d shift.x along north
  float stretch_ne;      // d shift.y along east
  float stretch_nn;      // d shift.y along north
};

WaveSum no_waves() {
  WaveSum s;
  s.height = 0.0;
  s.before = 0.0;
  s.stretch_before = 0.0;
  s.shift = vec2(0.0);
  s.slope = vec2(0.0);
  s.stretch_ee = 0.0;
  s.stretch_en = 0.0;
  s.stretch_ne = 0.0;
  s.stretch_nn = 0.0;
  return s;
}

// Adds what one wave does at a place. d: its direction, unit; height: of the water over the still sea, which gains rise
// along d; sway: how far the water has moved along d, which gains along that way and across to its side; before: height and gain along
// the way a quarter of a period before.
void add_swell(inout WaveSum sum, vec2 d, float height, float rise, float sway, float along, float across, vec2 before) {
  sum.height += height;
  sum.before += before.x;
  sum.stretch_before += before.y;
  sum.shift += sway * d;
  sum.slope += (rise - sway) * d;
  vec2 skew = (along - across) * d.x * d;
  sum.stretch_ee += across + skew.x;
  sum.stretch_en += skew.y;
  sum.stretch_ne += skew.y;
  sum.stretch_nn += along - skew.x;
}

// Adds one wave at v. Near its origin and the antipode, where its direction turns, it fades within a wavelength. weight
// fades the wave as a whole.
void add_wave(inout WaveSum sum, vec3 v, Frame frame, Wave wave, float weight) {
  float cosine = dot(v, wave.origin);
  vec2 toward = along_axes(wave.origin, frame);
  // Where the direction is undefined the wave has faded.
  float per_sine = inversesqrt(max(dot(toward, toward), 1.0e-12));
  float sine = dot(toward, toward) * per_sine;
  vec2 d = -per_sine * toward;
  float per_length = wave.wavenumber * 0.15915494309189535;
  float x = clamp(sine * per_length - 0.25, 0.0, 1.0);
  float fade = weight * x * x * (3.0 - 2.0 * x);
  float fade_slope = weight * 6.0 * x * (1.0 - x) * cosine * per_length;
  vec2 turn = cos_sin(wave.wavenumber * arc(sine, cosine) + wave.phase);
  float pinch = fade * wave.pinch;
  float sway = pinch * turn.x;
  float rise = wave.amplitude * (fade * wave.wavenumber * turn.x + fade_slope * turn.y);
  float along = fade_slope * wave.pinch * turn.x - pinch * wave.wavenumber * turn.y;
  float across = sway * cosine * per_sine;
  add_swell(sum, d, fade * wave.amplitude * turn.y, rise, sway, along, across,
            vec2(fade * wave.amplitude, -pinch * wave.wavenumber) * turn.x);
}

// Multiplies the whole sum by a factor that itself changes along east and north (shallow water holds waves back).
WaveSum attenuate(WaveSum sum, float factor, vec2 factor_slope) {
  WaveSum s;
  s.height = factor * sum.height;
  s.before = factor * sum.before;
  s.stretch_before = factor * sum.stretch_before;
  s.shift = factor * sum.shift;
  s.slope = factor * sum.slope + sum.height * factor_slope;
  s.stretch_ee = factor * sum.stretch_ee + sum.shift.x * factor_slope.x;
  s.stretch_en = factor * sum.stretch_en + sum.shift.x * factor_slope.y;
  s.stretch_ne = factor * sum.stretch_ne + sum.shift.y * factor_slope.x;
  s.stretch_nn = factor * sum.stretch_nn + sum.shift.y * factor_slope.y;
  return s;
}

// How much of its waves water leaves that grows shallow, 0..1: none where land begins. depth: of the still water;
// whole_depth: at which they are whole, radii, > 0.
float left_by_ground(float depth, float whole_depth) {
  float x = clamp(depth / whole_depth, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

// Waves as they are over a ground. ground_slope: of its height along east and north.
WaveSum held_by_ground(WaveSum sum, float depth, vec2 ground_slope, float whole_depth) {
  float x = clamp(depth / whole_depth, 0.0, 1.0);
  return attenuate(sum, left_by_ground(depth, whole_depth), -6.0 * x * (1.0 - x) / whole_depth * ground_slope);
}

// The same where the ground's slope is told as the gradient of its height, in the axes that the frame has.
WaveSum held_in_frame(WaveSum sum, Frame frame, float depth, vec3 gradient, float whole_depth) {
  return held_by_ground(sum, depth, along_axes(gradient, frame), whole_depth);
}

// Where the water of v has gone: the offset from a still sea of the given radius (14).
vec3 wave_offset(vec3 v, Frame frame, WaveSum sum) {
  return sum.height * v + sum.shift.x * frame.east + sum.shift.y * frame.north;
}

// The normal of the displaced surface, not yet of unit length, in the frame's axes (east, north, up): the cross product
// of the two tangents. Its third component is the Jacobian: 1 undisturbed, below 0 where the surface has folded over.
vec3 wave_normal(WaveSum sum) {
  vec3 east = vec3(1.0 + sum.height + sum.stretch_ee, sum.stretch_ne, sum.slope.x);
  vec3 north = vec3(sum.stretch_en, 1.0 + sum.height + sum.stretch_nn, sum.slope.y);
  return cross(east, north);
}
