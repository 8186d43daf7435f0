// Ground of nodes on which waves gather light, seen from the water.
#include "ground_from_water.glsl"
#include "felt_ground.glsl"
#include "wavy_bottom.glsl"

float gathered_in_water(vec3 offset, float depth, vec3 up, SceneLight scene) {
  return gathered_below(offset + depth * up, -depth * up, depth, pixel_footprint(up, offset, 0.1), up, scene);
}
