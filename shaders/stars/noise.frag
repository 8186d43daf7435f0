#include "soft_disc.glsl"
