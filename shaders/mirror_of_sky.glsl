// Water that mirrors the sky without clouds, and no land.
vec3 seen_in_mirror(LightAt at, vec3 ray, float rough, SceneLight scene) { return sky_along(at, ray, scene); }
