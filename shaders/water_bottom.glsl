// Water through which its bottom is seen.
#include "water_surface.glsl"

// The ground aside (radii, along the sphere) of the one right below the place, as far as it is known without its finest layers.
GroundAt ground_aside(vec3 aside, vec3 up);

// As mean_normal takes it.
float layer_rise(GroundAt ground);

// What waves add to the sunlight that comes from the bottom, by gathering it there. to_bottom: from the pixel, radii; footprint: how
// far apart neighbouring pixels see the bottom, rad.
vec3 gathered_on_bottom(vec3 sunlight, vec3 to_bottom, float depth, float footprint, LightAt at, SceneLight scene);

// Adds to land what is missing there, and the grain of its colour; nothing under water. up: unit.
void refine_land(inout GroundAt land, inout float grain, vec3 up, float depth);

vec3 light_from_below(Water w, LightAt at, vec3 refracted, float shade, SceneLight scene) {
  float deep = max(w.depth, 0.0);
  float dive = dive_of(refracted, at.up);
  // The bottom is where the ray meets it: one step from the depth below the surface comes close.
  vec3 aside = (refracted - dot(refracted, at.up) * at.up) * (deep / dive);
  vec3 bottom = normalize(at.up + aside);
  GroundAt found = ground_aside(aside, at.up);
  found.height = w.depth > 0.0 ? min(found.height, 0.0) : found.height;
  float depth = max(0.5 * (deep - found.height), 0.0);
  float grain = 0.0;
  refine_land(found, grain, bottom, w.depth);
  vec3 normal = mean_normal(bottom, 1.0 + max(found.height, 0.0), found, layer_rise(found), -refracted);
  vec3 albedo = grained(ground_albedo(bottom, found, normal, scene_bands()), grain);
  albedo = wetted(albedo, wet_part(found.height, water_extinction.w), water_refraction_index);
  vec3 light = light_through(albedo, normal, depth, depth / dive, at, shade, water_look(), scene);
  vec3 sunlight = sunlight_through(albedo, normal, depth, depth / dive, at, shade, water_look(), scene);
  vec3 to_bottom = refracted * (depth / dive), seen = surface_from_eye + to_bottom;
  float footprint = fineness.x * max(length(dFdx(seen)), length(dFdy(seen)));
  return light + gathered_on_bottom(sunlight, to_bottom, depth, footprint, at, scene);
}
