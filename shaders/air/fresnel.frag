// The air where nothing is behind it but the sky; surfaces take the air before them into account themselves.
#include "scene_light.glsl"
#include "output.glsl"

in vec3 view_ray;

void main() {
  Air air = scene_air();
  vec3 ray = normalize(view_ray);
  vec3 eye = eye_position();
  AirPath path = air_path(eye, ray, air.top);
  if (path.leave <= path.enter) discard;
  float opacity = air_opacity_before(air_opacity(path.cosine, air), path.cosine, path.leave - path.enter, air.top);
  float overhead = path.enter > 0.0 ? 0.0 : 0.10 * air.density;
  opacity = clamp(opacity + overhead * (1.0 - opacity), 0.0, 1.0);
  // Lit where the ray comes nearest to the planet.
  vec3 nearest = eye + ray * clamp(-dot(eye, ray), path.enter, path.leave);
  vec3 light = sun_light.rgb * 0.55 * air_light(normalize(nearest), sun_direction.xyz, air);
  float toward = dot(ray, sun_direction.xyz);
  light += sky_glow.rgb * (wide_glow(toward) + pow(max(toward, 0.0), 60.0));
  emit_veil(light * opacity, opacity);
}
