// A sea over nodes whose ground lies so deep that nothing of it is seen.
#include "water_surface.glsl"

float depth_below(vec3 up) { return 1.0; }

// Nothing holds waves back.
float wave_part_over_ground(float depth) { return 1.0; }
WaveSum waves_over_ground(WaveSum sum, Frame f, float depth) { return sum; }

vec3 light_from_below(Water w, LightAt at, vec3 ray, float shade, SceneLight scene) {
  return light_of_depths(at, shade, water_look(), scene);
}
