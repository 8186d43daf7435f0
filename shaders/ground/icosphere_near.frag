// The icosphere's ground so near that pixels are finer than its map: further layers of noise at every pixel.
#include "ground_surface.glsl"
#include "layer_block.glsl"

// The direction of a place less the anchor's, from the place's offset to the eye: no large numbers are subtracted.
vec3 direction_from_anchor(vec3 offset) {
  float eye_radius = 1.0 + eye_high.w;
  vec3 anchor = layer_anchor.xyz;
  float radius2 = eye_radius * eye_radius + 2.0 * eye_radius * dot(anchor, offset) + dot(offset, offset);
  float radius = sqrt(max(radius2, 1.0e-12));
  float climb = (2.0 * eye_radius * dot(anchor, offset) + dot(offset, offset)) / (radius + eye_radius);
  return (offset - anchor * climb) / radius;
}

// What the layers finer than the map add.
struct FineLayers {
  vec3 gradient;  // to that of the sum of layers
  float grain;    // to the colour, about -1..1: what is flat shows them, too
};

// level_footprint: of a pixel on level ground; on a steep slope that faces the eye it is less.
FineLayers fine_layers(vec3 offset, float level_footprint) {
  vec3 from_anchor = direction_from_anchor(offset);
  vec3 right = dFdx(from_anchor), above = dFdy(from_anchor);
  float footprint = min(level_footprint, sqrt(max(dot(right, right), dot(above, above))));
  uint seed = uint(planet_seed);
  float texel = ground_map_scale.x;
  float enters = 1.0 - smoothstep(0.4, 0.6, footprint / texel);
  FineLayers fine;
  fine.gradient = vec3(0.0);
  fine.grain = 0.0;
  float strength = 0.4;
  int first = int(ground_map_scale.y), end = int(ground_map_scale.z);
  float amplitude = enters * pow(terrain_persistence, float(first));
  for (int i = first; i < end; ++i) {
    float frequency = layer_place[i].w;
    float weight = layer_weight(frequency, footprint);
    if (weight <= 0.0) break;  // and so is that of all finer layers
    vec3 q = layer_place[i].xyz + frequency * from_anchor;
    Noise n = simplex_noise(layer_cell[i].xyz, q, layer_seed(i, seed));
    float slope = layer_slope(n.value, terrain_ridged != 0, terrain_ridge_sharpness);
    float shown = max(weight - layer_weight(frequency, texel), 0.0);
    fine.gradient += amplitude * shown * frequency * slope * n.gradient;
    fine.grain += enters * strength * shown * n.value;
    strength *= 0.8;
    amplitude *= terrain_persistence;
  }
  return fine;
}

// The gradient of the height from that of the sum of layers, at a place of known height over the sphere.
vec3 shaped(vec3 gradient, float height) {
  float slope = height_power_slope_at(height, terrain_height, terrain_power);
  return gradient * slope / amplitude_sum(terrain_persistence, terrain_octaves);
}

void main() {
  vec3 up = normalize(surface_position());
  GroundAt ground = ground_at(textureLod(ground_map, up, levels.z), up);
  float footprint = pixel_footprint(up, surface_from_eye, 0.12);
  FineLayers fine = fine_layers(surface_from_eye, footprint);
  vec3 gradient = shaped(fine.gradient, ground.height + sea.x - 1.0);
  ground.gradient += gradient - dot(gradient, up) * up;
  emit_ground(ground, fine.grain);
}
