// The surface of the water: what its ways of finding normals have in common.
#include "ground_map.glsl"
#include "output.glsl"
#include "lib/water.glsl"

in vec3 surface_from_eye;

WaterLook water_look() {
  WaterLook look;
  look.color = water_color.rgb;
  look.extinction = water_extinction.rgb;
  look.foam_color = water_foam_color.rgb;
  look.foam = water_foam;
  look.clarity = water_clarity;
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

// The ground in a direction (unit) near the place, as far as it is known without its finest layers.
GroundAt ground_below(vec3 up);

// As mean_normal takes it.
float layer_rise(GroundAt ground);

// Adds to land what is missing there, and the grain of its colour; nothing under water. up: unit.
void refine_land(inout GroundAt land, inout float grain, vec3 up, float depth);

// What comes from under the surface. ray: unit, from the eye.
vec3 light_from_below(Water w, LightAt at, vec3 ray, float shade, SceneLight scene) {
  float deep = max(w.depth, 0.0);
  vec3 refracted = refracted_ray(ray, w.normal, water_look());
  float dive = dive_of(refracted, at.up);
  // The bottom is where the ray meets it: one step from the depth below the surface comes close.
  vec3 bottom = normalize(at.up + refracted * (deep / dive));
  GroundAt found = ground_below(bottom);
  found.height = w.depth > 0.0 ? min(found.height, 0.0) : found.height;
  float depth = max(0.5 * (deep - found.height), 0.0);
  float grain = 0.0;
  refine_land(found, grain, bottom, w.depth);
  vec3 normal = mean_normal(bottom, 1.0 + max(found.height, 0.0), found, layer_rise(found), -refracted);
  vec3 albedo = grained(ground_albedo(bottom, found, normal, scene_bands()), grain);
  return light_through(albedo, normal, depth, depth / dive, at, shade, water_look(), scene);
}

// The shore belongs to the map of the ground, which is finer than either mesh: where it says land, the water's mesh shows
// land. There nothing is refracted and nothing mirrored, which costs less than a second way of shading would. up: unit, of
// the still water; height: over it, radii.
void emit_water(Water w, vec3 up, float height) {
  SceneLight scene = scene_light();
  LightAt at = light_at(up, 0.0, scene);
  vec3 ray = normalize(surface_from_eye);
  float shade = shade_of_clouds(up * sea.x);
  vec3 below = light_from_below(w, at, ray, shade, scene);
  vec3 mirrored = sky_along(at, reflect(ray, w.normal), scene);
  vec3 light = water_light(w, at, ray, below, mirrored, shade, water_look(), scene);
  emit_surface(through_air(light, at, surface_from_eye, scene), surface_from_eye, w.normal, sea.x - 1.0 + height);
}
