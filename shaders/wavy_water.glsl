// A sea of trochoidal waves; the normal is exact at every pixel, whatever the mesh carries.
#include "water_surface.glsl"
#include "wave_block.glsl"

in vec3 still_direction;

vec3 gathered_on_bottom(vec3 sunlight, vec3 to_bottom, float depth, float footprint, LightAt at, SceneLight scene) { return vec3(0.0); }

void main() {
  vec3 up = normalize(still_direction);
  vec4 map = textureLod(ground_map, up, levels.z);
  Frame frame = frame_at(up);
  WaveSum sum = waves_at(up, frame, pixel_footprint(side_of_eye(up), surface_from_eye, 0.2), map);
  emit_water(wavy_water(up, -map.w, sum, frame, max(sea.y, 1.0e-9), sea.w, water_look()), up, sum.height);
}
