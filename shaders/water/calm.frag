// A calm sea: a sphere with ripples of flow noise (Sandahl 2022, equations 12 and 13).
#include "water_light.glsl"
#include "output.glsl"

in vec3 still_direction;
in vec3 surface_from_eye;

void main() {
  vec3 up = normalize(still_direction);
  vec4 map = texture(ground_map, up);
  vec3 place = up * sea.x;
  if (map.w >= 0.0 && channel.x == 0) {
    emit_surface(through_air(shore_light(up, map, place), surface_from_eye), surface_from_eye, up, 0.0);
    return;
  }
  float footprint = length(surface_from_eye) * ray_forward.w / max(-dot(up, normalize(surface_from_eye)), 0.12);
  vec3 gradient = vec3(0.0);
  float rough = 0.0;
  float wash = 0.0;
  float frequency = water_ripple_frequency;
  uint seed = uint(planet_seed) + 71u;
  for (int i = 0; i < 2; ++i) {
    float shown = ripple.y > 0.0 ? layer_weight(frequency, footprint) : 0.0;
    float strength = 0.11 * (i == 0 ? 1.0 : 0.7);
    if (shown > 0.0) {
      vec3 q = up * frequency + layer_offset(i, seed);
      Noise n = flow_noise(ivec3(0), q, ripple.x * (i == 0 ? 1.0 : 2.0), layer_seed(i, seed));
      gradient += shown * strength * ripple.y * n.gradient;
      wash += shown * n.value * 0.5;
    }
    // What is too small to be seen makes the surface look rougher.
    rough += (1.0 - shown * shown) * strength * strength * water_ripples * water_ripples * 3.0;
    frequency *= 2.3;
  }
  float own = water_roughness * water_roughness;
  Water w;
  w.up = up;
  w.normal = surface_normal(up, 1.0, gradient);
  w.depth = -map.w;
  w.roughness = clamp(sqrt(sqrt(own * own + rough)), 0.02, 1.0);
  float line = water_clarity * 0.30;
  w.foam = water_foam * (1.0 - smoothstep(0.2, 1.0, w.depth / max(line, 1.0e-9) + 0.5 * wash));
  vec3 light = channel.x == 0 ? through_air(water_light(w, place, surface_from_eye), surface_from_eye) : vec3(0.0);
  emit_surface(light, surface_from_eye, w.normal, sea.x - 1.0);
}
