// The scene's water, and how it is seen through by an eye in it.
#include "cloud_map.glsl"
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

// The light of something in the water as it comes to an eye there. offset: from the eye.
vec3 to_eye_in_water(vec3 light, vec3 offset, SceneLight scene) {
  LightAt at = light_at(normalize(eye_position()), 0.0, scene);
  float way = length(offset);
  float shade = shade_of_clouds(sea.x * at.up);
  return through_water(light, lens.w, dot(offset, at.up) / way, way, at, shade, water_look(), scene);
}
