// The surface of the water: what its ways of finding normals have in common.
#include "ground_map.glsl"
#include "output.glsl"
#include "lib/water.glsl"

in vec3 surface_from_eye;

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

// How deep the water is (radii; below 0 where land stands out of it) in the direction of the place. Asked for first, and once.
float depth_below(vec3 up);

// What comes from under the surface. ray: unit, from the eye.
vec3 light_from_below(Water w, LightAt at, vec3 ray, float shade, SceneLight scene);

// The shore belongs to the map of the ground, which is finer than either mesh: where it says land, the water's mesh shows
// land. There nothing is refracted and nothing mirrored, which costs less than a second way of shading would. up: unit, of
// the still water; height: over it, radii.
void emit_water(Water w, vec3 up, float height) {
  SceneLight scene = scene_light();
  LightAt at = light_at(up, 0.0, scene);
  vec3 ray = normalize(surface_from_eye);
  float shade = shade_of_clouds(up * sea.x);
  vec3 below = light_from_below(w, at, ray, shade, scene);
  vec3 mirrored = sky_along(at, reflect(ray, w.facing), scene);
  vec3 light = water_light(w, at, ray, below, mirrored, shade, water_look(), scene);
  emit_surface(through_air(light, at, surface_from_eye, scene), surface_from_eye, w.normal, sea.x - 1.0 + height);
}
