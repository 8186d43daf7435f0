// The scene's water.
#include "frame_block.glsl"
#include "scene_block.glsl"
#include "lib/water.glsl"

WaterLook water_look() {
  WaterLook look;
  look.color = water_depths.rgb;
  look.extinction = water_extinction.rgb;
  look.foam_color = water_foam_color.rgb;
  look.foam = water_foam;
  look.clarity = water_depths.w;
  look.roughness = water_roughness;
  look.refraction_index = water_refraction_index;
  look.shininess = water_shininess;
  look.glow = water_glow;
  look.crust = water_crust;
  look.shading = water_shading;
  return look;
}
