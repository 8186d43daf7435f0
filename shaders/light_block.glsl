// What lights the scene and what shades it, from the scene's parameters.
#include "scene_block.glsl"
#include "frame_block.glsl"
#include "lib/light.glsl"

SceneLight scene_light() {
  SceneLight s;
  s.eye = eye_position();
  s.eye_height = eye_high.w;
  s.sun = sun_direction.xyz;
  s.sunlight = sun_light.rgb;
  s.ambient = sun_ambient;
  s.sky_glow = sky_glow.rgb;
  s.air.top = 1.0 + max(air_height, 1.0e-6);
  s.air.density = air_density;
  s.air.exponent = air_exponent;
  s.air.wrap = air_wrap;
  s.air.color = air_color.rgb;
  s.air.dusk = air_dusk_color.rgb;
  return s;
}
