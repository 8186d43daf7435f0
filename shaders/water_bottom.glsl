// Water through which its bottom is seen.
#include "water_surface.glsl"

// The ground in a direction (unit) near the place, as far as it is known without its finest layers.
GroundAt ground_below(vec3 up);

// As mean_normal takes it.
float layer_rise(GroundAt ground);

// How many times as much sunlight waves gather on the bottom. sunward: from the pixel to where that light enters the water, along the
// sphere, radii; way: of the light through the water.
float gathered_on_bottom(vec3 sunward, float way);

// Adds to land what is missing there, and the grain of its colour; nothing under water. up: unit.
void refine_land(inout GroundAt land, inout float grain, vec3 up, float depth);

vec3 light_from_below(Water w, LightAt at, vec3 ray, float shade, SceneLight scene) {
  float deep = max(w.depth, 0.0);
  vec3 refracted = refracted_ray(ray, w.facing, water_look());
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
  albedo = wetted(albedo, wet_part(found.height, water_extinction.w), water_refraction_index);
  vec3 light = light_through(albedo, normal, depth, depth / dive, at, shade, water_look(), scene);
  vec3 sunlight = sunlight_through(albedo, normal, depth, depth / dive, at, shade, water_look(), scene);
  float shown = pattern_shown(sunlight);
  if (shown <= 0.0 || depth <= 0.0) return light;
  vec3 down = refracted_ray(-scene.sun, at.up, water_look());
  float sun_dive = dive_of(down, at.up);
  vec3 sunward = depth * (refracted / dive - down / sun_dive);
  float factor = gathered_on_bottom(sunward - dot(sunward, at.up) * at.up, depth / sun_dive);
  return light + shown * (factor - 1.0) * sunlight;
}
