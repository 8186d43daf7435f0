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

// Nodes know nothing of their neighbours: what vertices tell goes on as it slopes here, and the layers that they lack are those of
// the place itself.
GroundAt ground_aside(vec3 aside, vec3 up) {
  const float seen = 0.25;  // of a pixel
  float pixel = length(surface_from_eye) * ray_forward.w;
  if (dot(aside, aside) <= seen * seen * pixel * pixel) return ground_here;
  vec3 place = water_place() + aside;
  GroundAt ground = node_ground(place, vec3(0.0));
  ground.height += dot(node_slope.xyz, aside);
  return ground;
}

void refine_land(inout GroundAt land, inout float grain, vec3 up, float depth) {}
