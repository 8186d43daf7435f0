// Water as it is seen: what it reflects, what one sees through it, and what floats on it.
#include "ground_light.glsl"
#include "output.glsl"

struct Water {
  vec3 normal;    // of the surface, unit
  float depth;    // of the still water, radii; at most 0 where there is land
  float foam;     // 0..1
  float roughness;
};

// Light from the bottom and from the water itself, along the refracted ray; from land as it is.
vec3 light_through(Water w, LightAt at, vec3 ray, float shade) {
  float deep = max(w.depth, 0.0);
  vec3 refracted = refract(ray, w.normal, 1.0 / water_refraction_index);
  float dive = max(-dot(refracted, at.up), 0.25);
  // The bottom is where the ray meets it: one step from the depth below the surface comes close.
  vec3 bottom = normalize(at.up + refracted * (deep / dive));
  GroundAt found = ground_at(textureLod(ground_map, bottom, levels.z), bottom);
  found.height = w.depth > 0.0 ? min(found.height, 0.0) : found.height;
  float depth = max(0.5 * (deep - found.height), 0.0);

  vec3 normal = slope_normal(bottom, 1.0 + max(found.height, 0.0), found.gradient);
  vec3 albedo = ground_albedo(bottom, found, normal);
  float sun_height = dot(at.up, sun_direction.xyz);
  vec3 left = transmitted(water_extinction.rgb, depth / dive);
  vec3 lit = ground_light(albedo, normal, at, shade) * transmitted(water_extinction.rgb, depth / max(sun_height, 0.3));
  vec3 body = water_color.rgb * (at.sun * (wrap_diffuse(sun_height, 0.15) * shade) + skylight(at, at.up)) * 0.6;
  return mix(body, lit, left);
}

// Light that the surface sends to the eye, before the air. ray: unit, from the eye; shade: part of the sunlight left by
// the clouds. The shore belongs to the map of the ground, which is finer than either mesh: where it says land, the
// water's mesh shows land.
vec3 water_light(Water w, LightAt at, vec3 ray, float shade) {
  float wet = w.depth > 0.0 ? 1.0 : 0.0;
  vec3 sun = sun_direction.xyz;
  vec3 sunlight = at.sun * shade;
  vec3 mirrored = reflect(ray, w.normal);
  vec3 light = light_through(w, at, ray, shade);
  if (water_shading == 0) {
    float cosine = max(-dot(ray, w.normal), 0.0);
    float r0 = reflectance_at_normal(1.0, water_refraction_index);
    vec3 between = normalize(sun - ray);
    float gleam = glitter(dot(w.normal, between), cosine, dot(w.normal, sun), w.roughness);
    float r_sun = schlick(max(dot(sun, between), 0.0), r0);
    light = mix(light, sky_along(at, mirrored), wet * schlick(cosine, r0)) + sunlight * (wet * min(gleam * r_sun, 40.0));
  } else {
    light += sunlight * (wet * phong(dot(mirrored, sun), water_shininess) * 0.08);
  }
  vec3 foam = water_foam_color.rgb * (sunlight * wrap_diffuse(dot(w.normal, sun), 0.1) + skylight(at, w.normal)) * 0.55;
  light = mix(light, foam, wet * w.foam);
  return light + water_color.rgb * (wet * water_glow * (1.0 - 0.95 * w.foam));
}
