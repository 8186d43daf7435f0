// Water that mirrors the sky with its clouds.
#include "cloudy_sky.glsl"

vec3 mirrored_sky(LightAt at, vec3 ray, SceneLight scene) { return sky_from(at, ray, scene); }
