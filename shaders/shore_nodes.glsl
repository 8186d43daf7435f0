// What lies under the water by the nodes of the ground, which the water is drawn with.
#include "water_bottom.glsl"
#include "node_surface.glsl"
#include "lib/shoaling.glsl"

GroundAt ground_here;

// Of the water over the still place that the nodes tell of, from the eye.
vec3 water_place();

float depth_below(vec3 up) {
  vec3 place = water_place();
  ground_here = node_ground(place, vec3(0.0));
  return -ground_here.height;
}

float wave_part_over_ground(float depth) { return left_ashore(depth, sea.w); }
WaveSum waves_over_ground(WaveSum sum, Frame f, float depth) {
  return held_ashore(sum, f, depth, ground_here.gradient, sea.w);
}

// Nodes know nothing of their neighbours: right below is near enough.
GroundAt ground_below(vec3 up) { return ground_here; }

void refine_land(inout GroundAt land, inout float grain, vec3 up, float depth) {}
