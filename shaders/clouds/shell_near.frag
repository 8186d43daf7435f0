// The shell of clouds so near that pixels are finer than its map: further layers of flow noise at every pixel, which
// stirring_layers are not.
#include "cloud_surface.glsl"

uniform vec4 layers;  // x, y: first and end of those added; z: angle of a texel of the map, rad; w: size of a texel from where they are added, pixels
uniform vec2 turn;    // cosine and sine of the angle by which their gradients are turned

void main() {
  CloudAt cloud = cloud_of_map();
  float footprint = pixel_footprint(cloud.up, surface_from_eye, 0.12);
  float enters = 1.0 - smoothstep(0.72, 1.0, layers.w * footprint / layers.z);
  vec3 place = drifted(cloud.up, cloud_turn.xy);
  vec3 entry = drifted(cloud_entry(cloud), cloud_turn.xy);
  uint seed = cloud_seed(planet_seed);
  float frequency = clouds_frequency * exp2(layers.x);
  float amplitude = enters * pow(clouds_persistence, layers.x) / amplitude_sum(clouds_persistence, clouds_octaves);
  // Where even all of them could make no cloud, none is computed.
  float most = cloud.noise + 1.02 * amplitude * amplitude_sum(clouds_persistence, int(layers.y) - int(layers.x));
  int end = cloud_thickness(most, clouds_coverage, clouds_softness) > 0.0 ? int(layers.y) : 0;
  for (int i = int(layers.x); i < end; ++i) {
    float shown = layer_weight(frequency, footprint);
    if (shown <= 0.0) break;  // and so are all finer layers
    vec3 offset = layer_offset(i, seed);
    float here = turned_noise(ivec3(0), frequency * place + offset, turn, layer_seed(i, seed)).value;
    float there = turned_noise(ivec3(0), frequency * entry + offset, turn, layer_seed(i, seed)).value;
    shown = max(shown - layer_weight(frequency, layers.z), 0.0);
    cloud.noise += amplitude * shown * here;
    cloud.rise += amplitude * shown * (there - here);
    frequency *= 2.0;
    amplitude *= clouds_persistence;
  }
  emit_clouds(cloud);
}
