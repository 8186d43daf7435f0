// A sea of trochoidal waves; the normal is exact at every pixel, whatever the mesh carries.
#include "water_light.glsl"
#include "wave_block.glsl"

in vec3 still_direction;
in vec3 surface_from_eye;

void main() {
  vec3 up = normalize(still_direction);
  vec4 map = textureLod(ground_map, up, levels.z);
  Frame frame = frame_at(up);
  float footprint = pixel_footprint(up, surface_from_eye, 0.2);
  WaveSum sum = held_by_ground(waves_at(up, frame, footprint), map, frame);
  vec3 n = wave_normal(sum);
  float crest = 1.0 - smoothstep(0.25, 0.75, n.z);
  n = normalize(n);
  float rise = sum.height * planet_radius / max(waves_amplitude, 1.0e-9);  // in amplitudes

  Water w;
  w.normal = normalize(n.x * frame.east + n.y * frame.north + max(n.z, 0.05) * up);
  w.depth = -map.w;
  w.roughness = water_roughness;
  float shore = 1.0 - smoothstep(0.05, 0.35, w.depth / sea.w - 0.05 * rise);
  w.foam = water_foam * clamp(crest * smoothstep(0.2, 1.6, rise) + 0.8 * shore, 0.0, 1.0);
  LightAt at = light_at(up, 0.0);
  vec3 light = water_light(w, at, normalize(surface_from_eye), cloud_shade(up * sea.x));
  emit_surface(through_air(light, at, surface_from_eye), surface_from_eye, w.normal, sea.x - 1.0 + sum.height);
}
