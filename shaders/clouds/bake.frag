// Fills a face of a map of the clouds: flow noise (Sandahl 18), its sum divided by the sum of amplitudes.
#include "scene_block.glsl"
#include "lib/clouds.glsl"

uniform int octaves;
uniform int cyclones;
uniform vec4 cyclone[cyclone_count];  // xyz: eye; w: radius
uniform vec4 turns[6];  // cosine and sine of the angle by which each layer's gradients are turned, two layers in each

in vec3 cube_direction;
out vec4 fragment;

void main() {
  vec3 direction = normalize(cube_direction);
  vec3 wound = direction;
  for (int i = 0; i < cyclones; ++i) wound = unwound(wound, cyclone[i], cyclone_turn(clouds_swirl));
  uint seed = cloud_seed(planet_seed);
  vec3 warp = vec3(0.0);
  float frequency = clouds_frequency;
  float amplitude = 1.0;
  float sum = 0.0;
  for (int i = 0; i < octaves; ++i) {
    vec4 pair = turns[i >> 1];
    vec2 turn = (i & 1) == 0 ? pair.xy : pair.zw;
    vec3 place = flow_place(i < wound_layers ? wound : direction, frequency, stirred(i, clouds_warp), warp, i, seed);
    // Where warp has drawn a layer out, the map may be too coarse for its cells.
    vec3 right = dFdx(place), up = dFdy(place);
    float shown = layer_weight(1.0, sqrt(0.5 * (dot(right, right) + dot(up, up))));
    sum += flow_layer(place, amplitude * shown, turn, i, seed, warp);
    frequency *= 2.0;
    amplitude *= clouds_persistence;
  }
  // Every channel: the caller masks the one that is meant.
  float total = amplitude_sum(clouds_persistence, clouds_octaves);
  fragment = vec4(noise_to_map(cloud_noise_of(sum, total, clouds_belts, direction.z)));
}
