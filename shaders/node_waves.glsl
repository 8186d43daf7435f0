// The waves of a sea over a ground of nodes: long ones as on any sphere, short ones told from below the eye.
#include "frame_block.glsl"
#include "lib/short_waves.glsl"
#include "wave_block.glsl"

uniform highp sampler2D wave_table;  // a row for the region around each axis, two texels a wave (src/passes/wave_table.cpp)

layout(std140) uniform WaveAnchorBlock {
  vec4 wave_anchor;    // xyz: below the eye, unit; w: height of the eye over the sea
  vec4 wave_east;      // xyz: axes there
  vec4 wave_north;
  vec4 wave_breaking;  // x: Jacobian below which water is foam; y: softness; z: choppiness
  ivec4 wave_counts;   // xyz: waves in each row
};

// The sea at a still place.
struct SeaAt {
  vec3 up;
  Frame frame;
  WaveSum sum;
  float unseen;  // variance of the slopes of waves that are left out
};

void add_short_waves(inout SeaAt sea_at, vec2 arcs, float footprint) {
  vec3 parts = parts_of_regions(sea_at.up);
  for (int axis = 0; axis < 3; ++axis) {
    float part = parts[axis];
    int count = part > 0.0 ? wave_counts[axis] : 0;
    for (int i = 0; i < count; ++i) {
      vec4 motion = texelFetch(wave_table, ivec2(2 * i, axis), 0), shape = texelFetch(wave_table, ivec2(2 * i + 1, axis), 0);
      float shown = wave_weight(motion.z, footprint);
      if (shown <= 0.0) {  // and so is that of all shorter ones
        sea_at.unseen += part * part * shape.w;
        break;
      }
      float slope = part * shape.x * motion.z;
      sea_at.unseen += 0.5 * (1.0 - shown * shown) * slope * slope;
      ShortWave wave;
      wave.direction = motion.xy;
      wave.wavenumber = motion.z;
      wave.phase = motion.w;
      wave.amplitude = shape.x;
      wave.pinch = shape.y;
      wave.bend = shape.z;
      add_short_wave(sea_at.sum, arcs, wave, part * shown);
    }
  }
}

// from_eye: of the still place; footprint: rad; ground_slope: gradient of the ground's height.
SeaAt sea_waves(vec3 from_eye, float footprint, float depth, vec3 ground_slope) {
  Frame axes;
  axes.east = wave_east.xyz;
  axes.north = wave_north.xyz;
  vec3 anchor = wave_anchor.xyz, offset = (from_eye + wave_anchor.w * anchor) / sea.x;
  SeaAt at;
  at.up = normalize(anchor + offset);
  at.frame = carried_axes(axes, anchor, at.up);
  at.sum = no_waves();
  at.unseen = 0.0;
  add_short_waves(at, arcs_from_anchor(offset, axes), footprint);
  for (int i = 0; i < int(sea.z); ++i) add_long_wave(at.sum, at.unseen, at.up, at.frame, i, footprint);
  float left = left_by_ground(depth, sea.w);
  at.unseen *= left * left;
  vec2 slope = vec2(dot(ground_slope, at.frame.east), dot(ground_slope, at.frame.north));
  at.sum = held_by_ground(at.sum, depth, slope, sea.w);
  return at;
}
