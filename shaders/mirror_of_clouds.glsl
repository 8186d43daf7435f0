// Water that mirrors the sky with its clouds.
#include "cloudy_sky.glsl"

vec3 seen_in_mirror(LightAt at, vec3 ray, float rough, SceneLight scene) { return sky_from(at, ray, scene); }
