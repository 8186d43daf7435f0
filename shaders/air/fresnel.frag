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
  float within = path.enter > 0.0 ? 0.0 : 1.0;
  float overhead = within * 0.10 * air.density;
  opacity = clamp(opacity + overhead * (1.0 - opacity), 0.0, 1.0);
  // Lit where the ray comes nearest to the planet.
  vec3 nearest = eye + ray * clamp(-dot(eye, ray), path.enter, path.leave);
  vec3 light = sun_light.rgb * 0.55 * air_light(normalize(nearest), sun_direction.xyz, air);
  if (within > 0.0) {
    // From within, the sky glows around a low sun.
    vec3 up = normalize(eye);
    float toward = max(dot(ray, sun_direction.xyz), 0.0);
    float climb = dot(up, sun_direction.xyz);
    float glow = pow(toward, 6.0) * 0.5 + pow(toward, 60.0);
    float low = smoothstep(-0.25, 0.0, climb) * (1.0 - smoothstep(0.1, 0.5, climb));
    light += sun_light.rgb * mix(vec3(1.0), air.dusk, 0.8 * low) * glow * (0.25 + low) * smoothstep(-0.3, -0.02, climb);
  }
  emit_veil(light * opacity, opacity);
}
