// Land on the water's mesh where the map of the ground is as fine as pixels.
#include "shore_map.glsl"

// From where the map of the ground is fine enough, clouds lie before what is seen of themselves in the water.
vec3 mirrored_sky(LightAt at, vec3 ray, SceneLight scene) { return sky_along(at, ray, scene); }

void refine_land(inout GroundAt land, inout float grain, vec3 up, float depth) {}
