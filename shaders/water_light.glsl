// Water as it is seen: what it reflects, what one sees through it, and what floats on it.
#include "ground_light.glsl"

struct Water {
  vec3 up;        // unit, from the planet's centre
  vec3 normal;    // of the surface, unit
  float depth;    // of the still water, radii, > 0
  float foam;     // 0..1
  float roughness;
};

// Light from the bottom and from the water itself, along the refracted ray.
vec3 light_through(Water w, vec3 ray, float shade) {
  vec3 refracted = refract(ray, w.normal, 1.0 / water_refraction_index);
  float dive = max(-dot(refracted, w.up), 0.25);
  // The bottom is where the ray meets it: one step from the depth below the surface comes close.
  vec3 bottom = normalize(w.up + refracted * (w.depth / dive));
  vec4 map = texture(ground_map, bottom);
  float depth = max(0.5 * (w.depth - map.w), 0.0);

  vec3 extinction = water_extinction.rgb;
  vec3 normal = surface_normal(bottom, 1.0, map.xyz);
  vec3 albedo = ground_albedo(bottom, min(map.w, 0.0), map.xyz, normal);
  float sun_dive = max(dot(w.up, sun_direction.xyz), 0.3);
  vec3 lit = ground_light(albedo, bottom, normal, 0.0, shade) * transmitted(extinction, depth / sun_dive);
  vec3 left = transmitted(extinction, depth / dive);
  float day = wrap_diffuse(dot(w.up, sun_direction.xyz), 0.15);
  vec3 body = water_color.rgb * (sunlight_at(w.up, 0.0) * day * shade + skylight_at(w.up, w.up)) * 0.6;
  return lit * left + body * (1.0 - left);
}

// Light that the surface sends to the eye, before the air. place: position; offset: from the eye.
vec3 water_light(Water w, vec3 place, vec3 offset) {
  vec3 ray = normalize(offset);
  vec3 sun = sun_direction.xyz;
  float shade = cloud_shade(place);
  float cosine = max(-dot(ray, w.normal), 0.0);
  vec3 inside = light_through(w, ray, shade);
  vec3 sunlight = sunlight_at(w.up, 0.0) * shade;
  vec3 mirrored = reflect(ray, w.normal);
  vec3 light;
  if (water_shading == 0) {
    float r0 = reflectance_at_normal(1.0, water_refraction_index);
    float reflectance = schlick(cosine, r0);
    vec3 between = normalize(sun - ray);
    float gleam = glitter(dot(w.normal, between), cosine, dot(w.normal, sun), w.roughness);
    float r_sun = schlick(max(dot(sun, between), 0.0), r0);
    light = mix(inside, sky_along(w.up, mirrored), reflectance) + sunlight * min(gleam * r_sun, 40.0);
  } else {
    light = inside + sunlight * phong(dot(mirrored, sun), water_shininess) * 0.08;
  }
  vec3 foam = water_foam_color.rgb * (sunlight * wrap_diffuse(dot(w.normal, sun), 0.1) + skylight_at(w.up, w.normal)) * 0.55;
  light = mix(light, foam, w.foam);
  return light + water_color.rgb * water_glow * (1.0 - 0.8 * w.foam);
}

// The shore belongs to the map of the ground, which is finer than either mesh: where it says land, the water's mesh shows
// land.
vec3 shore_light(vec3 up, vec4 map, vec3 place) {
  vec3 normal = surface_normal(up, 1.0 + max(map.w, 0.0), map.xyz);
  return ground_light(ground_albedo(up, map.w, map.xyz, normal), up, normal, map.w, cloud_shade(place));
}
