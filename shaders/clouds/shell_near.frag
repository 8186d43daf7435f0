// The shell of clouds so near that pixels are finer than its map: further layers of flow noise at every pixel. Nothing
// stirs them, and they turn no faster than the finest layer of the map, so that they do not boil.
#include "cloud_surface.glsl"

uniform vec4 layers;  // x, y: first and end of those added; z: angle of a texel of the map, rad; w: size of a texel from where they are added, pixels
uniform vec2 turn;    // cosine and sine of the angle by which their gradients are turned

void main() {
  CloudAt cloud = cloud_of_map();
  float footprint = pixel_footprint(cloud.up, surface_from_eye, 0.12);
  float enters = 1.0 - smoothstep(0.72, 1.0, layers.w * footprint / layers.z);
  vec3 place = drifted(cloud.up, cloud_turn.xy);
  vec3 sunward = drifted(cloud.toward, cloud_turn.xy);
  uint seed = cloud_seed(planet_seed);
  float frequency = clouds_frequency * exp2(layers.x);
  float amplitude = enters * pow(clouds_persistence, layers.x) / amplitude_sum(clouds_persistence, clouds_octaves);
  // Where even all of them could make no cloud, none is computed.
  float most = cloud.noise + 1.02 * amplitude * amplitude_sum(clouds_persistence, int(layers.y) - int(layers.x));
  int end = cloud_thickness(most, clouds_coverage, clouds_softness) > 0.0 ? int(layers.y) : 0;
  for (int i = int(layers.x); i < end; ++i) {
    float shown = layer_weight(frequency, footprint);
    if (shown <= 0.0) break;  // and so are all finer layers
    Noise n = turned_noise(ivec3(0), frequency * place + layer_offset(i, seed), turn, layer_seed(i, seed));
    shown = max(shown - layer_weight(frequency, layers.z), 0.0);
    cloud.noise += amplitude * shown * n.value;
    // Beyond a third of a cell a gradient tells nothing.
    cloud.rise += amplitude * shown * dot(n.gradient, sunward) * min(frequency * cloud.reach, 0.33);
    frequency *= 2.0;
    amplitude *= clouds_persistence;
  }
  emit_clouds(cloud);
}
