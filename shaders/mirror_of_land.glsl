// Water that mirrors land before a sky with its clouds.
#include "cloudy_sky.glsl"
#include "land_in_mirror.glsl"

vec3 seen_in_mirror(LightAt at, vec3 ray, float rough, SceneLight scene) {
  return behind_land(sky_from(at, ray, scene), true, at, ray, rough, scene);
}
