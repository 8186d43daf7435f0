// A calm sea with ripples of flow noise (Sandahl 2022, equations 12 and 13); close to it each layer carries a finer one.
#include "calm_water.glsl"
#include "lib/noise.glsl"

void main() {
  vec3 up = water_direction();
  float footprint = pixel_footprint(up, surface_from_eye, 0.12);
  uint seed = uint(planet_seed) + 71u;
  float frequency = water_ripple_frequency;
  float strength = first_ripple;
  vec2 turn = ripple_turn.xy;
  Ripples r;
  r.gradient = vec3(0.0);
  r.rough = 0.0;
  r.wash = 0.0;
  for (int layer = 0; layer < int(ripple_turn.z); ++layer) {
    float shown = layer_weight(frequency, footprint);
    Noise n = turned_noise(ivec3(0), up * frequency + layer_offset(layer, seed), turn, layer_seed(layer, seed));
    r.gradient += shown * strength * ripple.x * n.gradient;
    if (layer < told_ripples) {
      r.wash += shown * n.value * 0.5;
      r.rough += unseen_roughness(strength, shown);
    }
    frequency *= 2.3;
    strength *= next_ripple;
    turn = vec2(turn.x * turn.x - turn.y * turn.y, 2.0 * turn.x * turn.y);  // twice as fast
  }
  r.crust = mix(water_crust, crust_cover(r.wash, water_crust), layer_weight(water_ripple_frequency, footprint));
  emit_calm_water(r, up);
}
