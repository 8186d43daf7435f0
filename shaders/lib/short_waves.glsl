// Waves that are short beside the planet, told from an anchor near the eye (Michelic 2018, 7 to 10), on the unit sphere. Of
// such waves none is seen from further than some hundred of its lengths, and its origin is far: so its arc from there is a short
// polynomial of where a place lies from the anchor, without the roots and arc tangents of lib/anchored_waves.glsl.
#include "lib/shoaling.glsl"

// One wave as the anchor sees it.
struct ShortWave {
  vec2 direction;    // in which it runs at the anchor, along the anchor's axes; unit
  float wavenumber;  // w, rad per radian of arc
  float phase;       // at the anchor, reduced to one turn
  float amplitude;   // A
  float pinch;       // Q A
  float bend;        // cotangent of the arc from its origin to the anchor
  float begins;      // gained_phase where it begins to feel the ground
};

// How it runs at a place.
struct Course {
  vec2 direction;  // as long as shorter says
  float shorter;   // how many times as short as in deep water the wave is
  float phase;
};

// The sphere is divided into six regions around its axes, each of which has its waves from origins a quarter of a great
// circle from its middle: so no place sees the origin of a wave, from which it runs to all sides, or the antipode. Returns
// how strong the waves of the regions around the axes x, y and z are at a place, those of the positive axes or the negative
// ones as the place lies; squares sum to 1. v: unit.
vec3 parts_of_regions(vec3 v) {
  vec3 size = abs(v);
  float most = max(size.x, max(size.y, size.z));
  vec3 part = smoothstep(vec3(0.95), vec3(1.0), size / most);
  return part * inversesqrt(dot(part, part));
}

// Where a place lies from the anchor, arcs along its axes: Riemann's normal coordinates. offset: its direction less the
// anchor's, of a length below 0.3; axes: of the anchor.
vec2 arcs_from_anchor(vec3 offset, Frame axes) {
  vec2 along = along_axes(offset, axes);
  float square = dot(along, along);
  return along * (1.0 + square * (0.16666666666666666 + square * (0.075 + square * 0.044642857142857144)));
}

// The axes of the anchor, carried along the great circle to v. Unit vectors; not to the antipode.
Frame carried_axes(Frame axes, vec3 anchor, vec3 v) {
  vec3 middle = (anchor + v) / (1.0 + dot(anchor, v));
  Frame f;
  f.east = axes.east - dot(axes.east, v) * middle;
  f.north = axes.north - dot(axes.north, v) * middle;
  return f;
}

// arcs: arcs_from_anchor; directions are told along the carried axes. In deep water; what the arc gains by the fourth power of
// arcs is neglected.
Course course_of(ShortWave wave, vec2 arcs) {
  float ahead = dot(wave.direction, arcs);
  float aside = wave.direction.x * arcs.y - wave.direction.y * arcs.x;
  float half_bend = 0.5 * wave.bend;
  float curve = aside * (half_bend - ahead * (0.16666666666666666 + half_bend * wave.bend));
  Course course;
  course.phase = wave.phase + wave.wavenumber * (ahead + aside * curve);
  course.direction = wave.direction + 2.0 * curve * vec2(-wave.direction.y, wave.direction.x);
  course.direction *= 1.0 - 2.0 * curve * curve;  // a unit vector, without a root
  course.shorter = 1.0;
  return course;
}

// The same over a ground that the wave feels.
Course ashore(Course course, ShortWave wave, Shore shore) {
  Shoaling s = shoaling(wave.wavenumber, wave.begins, shore);
  course.phase += s.phase;
  course.direction += s.turn;
  course.shorter = sqrt(max(dot(course.direction, course.direction), 1.0e-6));
  return course;
}

// Adds a wave to the sum at a place; weight fades it as a whole. Slopes and shifts are told along the axes of the course.
// A shorter wave sways less, so that it folds no sooner. Neglected: that crests spread.
void add_short_wave(inout WaveSum sum, Course course, ShortWave wave, float weight) {
  vec2 turn = cos_sin(course.phase);
  float height = weight * wave.amplitude, pinch = weight * wave.pinch, longer = 1.0 / course.shorter;
  float sway = min(longer, 1.0) * pinch * turn.x, squeeze = min(course.shorter, 1.0) * pinch * wave.wavenumber;
  add_swell(sum, longer * course.direction, height * turn.y, height * wave.wavenumber * course.shorter * turn.x, sway,
            -squeeze * turn.y, 0.0, vec2(height, -squeeze) * turn.x);
}
