// The waves of a sea over a ground of nodes: long ones as on any sphere, short ones told from below the eye.
#include "frame_block.glsl"
#include "lib/caustics.glsl"
#include "wave_block.glsl"

// Two vec4s a wave; those of a region one after another, the longest first (src/passes/wave_lists.cpp). No block is longer
// than any driver takes.
layout(std140) uniform NearWaveBlock {
  vec4 wave_anchor;    // xyz: below the eye, unit; w: height of the eye over the sea
  vec4 wave_east;      // xyz: axes there
  vec4 wave_north;
  vec4 wave_breaking;  // x: Jacobian below which water is foam; y: softness; z: choppiness
  vec4 wave_shore;     // x: 1 over the usual slope of shores; y: depth below which waves feel the ground; z: variance of the slopes of all; w: first layer of noise that tears foam, or -1
  ivec4 wave_axes;     // of the regions that reach here, axes around which they lie; w: how many they are, 0..3
  ivec4 waves_begin;   // where the waves of each region begin in the first list, and the last end
  ivec4 waves_go_on;   // the same of the second list
  vec4 waves_left;     // of each region, variance of the slopes of waves in no list
  vec4 wave_list[1000];
};
layout(std140) uniform MoreWaveBlock {
  vec4 more_waves[1000];
};

uniform int first_of_pixel;  // the first short wave that the vertices of a level of nodes don't carry

const int all_short_waves = 1000;

// Whether waves may feel the ground at all.
bool feels_ground();
// The ground under the place: how deep it lies, and its slope along the axes.
float felt_depth();
vec2 felt_slope(Frame axes);

// The sea at a still place, not yet held by the ground.
struct SeaAt {
  vec3 up;
  vec2 arcs;  // from below the eye
  Frame frame;
  Shore shore;
  WaveSum sum;
  bool gathers;  // whether the lens is asked for, in place of the sum
  Lens lens;
  float seen;  // twice the variance of slopes of the short waves in the sum
};

// from_eye: of the still place.
SeaAt still_sea(vec3 from_eye) {
  Frame axes;
  axes.east = wave_east.xyz;
  axes.north = wave_north.xyz;
  vec3 anchor = wave_anchor.xyz, offset = (from_eye + wave_anchor.w * anchor) / sea.x;
  SeaAt at;
  at.up = normalize(anchor + offset);
  at.arcs = arcs_from_anchor(offset, axes);
  at.frame = carried_axes(axes, anchor, at.up);
  at.shore.depth = felt_depth();
  at.shore.rise = wave_shore.x * felt_slope(at.frame);
  at.shore.per_slope = wave_shore.x;
  at.shore.felt_depth = wave_shore.y;
  at.sum = no_waves();
  at.gathers = false;
  at.lens = no_lens();
  at.seen = 0.0;
  return at;
}

// Adds a wave as it is in a list, if samples a footprint apart can show it. Returns whether they could in deep water; else
// they can't show those that follow.
bool add_listed(inout SeaAt at, vec4 motion, vec4 shape, float part, float footprint) {
  float shown = part * wave_weight(motion.z, footprint);
  if (shown <= 0.0) return false;
  ShortWave wave;
  wave.direction = motion.xy;
  wave.wavenumber = motion.z;
  wave.phase = motion.w;
  wave.amplitude = shape.x;
  wave.pinch = wave_breaking.z * shape.x;
  wave.bend = shape.z;
  wave.begins = shape.y;
  Course course = course_of(wave, at.arcs);
  if (feels_ground()) {
    course = ashore(course, wave, at.shore);
    shown = min(shown, part * wave_weight(motion.z * course.shorter, footprint));
  }
  if (at.gathers) {
    add_lens(at.lens, course, wave, shown);
    return true;
  }
  add_short_wave(at.sum, course, wave, shown);
  float slope = shown * shape.x * motion.z;
  at.seen += slope * slope;
  return true;
}

// How strong a region's waves are at a place.
float part_of_region(int region, vec3 parts) { return parts[wave_axes[region]]; }

// Adds a region's short waves [from, to), as far as samples can show them.
void add_short_waves(inout SeaAt at, int region, float part, int from, int to, float footprint) {
  int begin = waves_begin[region], here = waves_begin[region + 1] - begin, i = from;
  for (int end = min(here, to); i < end; ++i) {
    if (!add_listed(at, wave_list[2 * (begin + i)], wave_list[2 * (begin + i) + 1], part, footprint)) return;
  }
  begin = waves_go_on[region] - here;
  for (int end = min(waves_go_on[region + 1] - begin, to); i < end; ++i) {
    if (!add_listed(at, more_waves[2 * (begin + i)], more_waves[2 * (begin + i) + 1], part, footprint)) return;
  }
}

// Variance of the slopes of a region's short waves, from one on.
float variance_from(int region, int from) {
  int begin = waves_begin[region], here = waves_begin[region + 1] - begin, next = waves_go_on[region];
  if (from < here) return wave_list[2 * (begin + from) + 1].w;
  return from - here < waves_go_on[region + 1] - next ? more_waves[2 * (next + from - here) + 1].w : waves_left[region];
}
