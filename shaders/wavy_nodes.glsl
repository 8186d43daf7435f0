// A sea of waves over a ground of nodes; the normal is exact at every pixel, whatever the mesh carries.
#include "shore_nodes.glsl"
#include "node_waves.glsl"

in vec3 still_from_eye;

vec3 water_place() { return still_from_eye; }

void main() {
  float depth = depth_below(vec3(0.0));
  float footprint = pixel_footprint(normalize(eye_position() + still_from_eye), surface_from_eye, 0.2);
  SeaAt at = sea_waves(still_from_eye, footprint, depth, ground_here.gradient);
  Breaking breaking;
  breaking.fold = wave_breaking.x;
  breaking.softness = wave_breaking.y;
  breaking.choppiness = wave_breaking.z;
  Water water = open_water(at.up, depth, at.sum, at.frame, at.unseen, breaking, sea.w, water_look());
  emit_water(water, at.up, at.sum.height);
}
