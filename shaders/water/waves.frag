// A sea of trochoidal waves; the normal is exact at every pixel, whatever the mesh carries.
#include "water_light.glsl"
#include "output.glsl"
#include "wave_block.glsl"

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
  float footprint = length(surface_from_eye) * ray_forward.w / max(-dot(up, normalize(surface_from_eye)), 0.2);
  Frame frame = frame_at(up);
  WaveSum sum = held_by_ground(waves_at(up, frame, footprint), map, frame);
  vec3 n = wave_normal(sum);
  float jacobian = n.z;
  n = normalize(n);

  Water w;
  w.up = up;
  w.normal = normalize(n.x * frame.east + n.y * frame.north + max(n.z, 0.05) * up);
  w.depth = max(-map.w, 0.0);
  w.roughness = water_roughness;
  float crest = 1.0 - smoothstep(0.25, 0.75, jacobian);
  float rise = sum.height / max(0.25 * sea.w, 1.0e-9);  // in amplitudes
  float shore = 1.0 - smoothstep(0.05, 0.35, w.depth / sea.w - 0.05 * rise);
  w.foam = water_foam * clamp(crest * smoothstep(0.2, 1.6, rise) + 0.8 * shore, 0.0, 1.0);
  vec3 light = channel.x == 0 ? through_air(water_light(w, place, surface_from_eye), surface_from_eye) : vec3(0.0);
  emit_surface(light, surface_from_eye, w.normal, sea.x - 1.0 + sum.height);
}
