// An eye of which the lens, or a part of it, is under water.
#include "cloud_map.glsl"
#include "water_look.glsl"

// Whether a ray from the eye begins in the water.
bool begins_in_water(vec3 ray) { return dot(lens.xyz, ray) < 0.0; }

// The light of something in the water as it comes to an eye there. offset: from the eye.
vec3 to_eye_in_water(vec3 light, vec3 offset, SceneLight scene) {
  LightAt at = light_at(normalize(eye_position()), 0.0, scene);
  float way = length(offset);
  float shade = shade_of_clouds(sea.x * at.up);
  return through_water(light, lens.w, dot(offset, at.up) / way, way, at, shade, water_look(), scene);
}
