// Ground on which water gathers no light.
#include "ground_from_water.glsl"

float gathered_in_water(vec3 offset, float depth, vec3 up, SceneLight scene) { return 0.0; }
