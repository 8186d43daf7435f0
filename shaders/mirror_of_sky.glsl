// Water that mirrors the sky without clouds.
vec3 mirrored_sky(LightAt at, vec3 ray, SceneLight scene) { return sky_along(at, ray, scene); }
