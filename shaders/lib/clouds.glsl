// Clouds as flow noise on a sphere (Sandahl 2022, equation 18).
#include "lib/noise.glsl"

// At most so many cyclones stir the clouds of a planet.
const int cyclone_count = 10;

// Cyclone i of a planet. xyz: its eye (unit), 15 to 50 degrees from the equator, north and south by turns; w: its radius,
// as a chord of the unit sphere.
vec4 cyclone_place(int i, uint seed) {
  vec3 dice = hash_parts(hash_cell(ivec3(i, 3, 29), seed));
  float sine = mix(0.26, 0.77, dice.x / 1023.0);
  float longitude = 6.283185307179586 * dice.y / 1024.0;
  float level = sqrt(1.0 - sine * sine);
  return vec4(level * cos(longitude), level * sin(longitude), (i & 1) == 0 ? sine : -sine,
              mix(0.28, 0.62, dice.z / 1023.0));
}

// Where the air at a direction (unit) was before a cyclone wound it up, unit. turn: tangent of half the angle by which its
// eye has turned; it winds with the sun's way in the south and against it in the north, as on earth.
vec3 unwound(vec3 direction, vec4 cyclone, float turn) {
  vec3 eye = vec3(cyclone.x, cyclone.y, cyclone.z);
  float along = dot(direction, eye);
  float near = max(1.0 - (2.0 - 2.0 * along) / (cyclone.w * cyclone.w), 0.0);
  float t = (cyclone.z > 0.0 ? -turn : turn) * near * near;
  // Rodrigues' rotation around the eye, with the cosine and sine of twice the arc tangent of t.
  float share = 2.0 / (1.0 + t * t);
  return direction + share * t * cross(eye, direction) + share * t * t * (along * eye - direction);
}

// How far the eye of a cyclone has turned, as unwound takes it. swirl: 0..1.
float cyclone_turn(float swirl) {
  return 3.0 * swirl;
}

// A direction as the clouds have it, which drift around the planet. turn: cosine and sine of the way that they have come.
vec3 drifted(vec3 direction, vec2 turn) {
  return vec3(turn.x * direction.x + turn.y * direction.y, turn.x * direction.y - turn.y * direction.x, direction.z);
}

// Cyclones wind up so many of the coarsest layers. Finer ones, which are puffs and not weather, would only be smeared.
const int wound_layers = 2;

// So many of the coarsest layers stir those that are finer, and turn each twice as fast as the one before. Further ones
// are puffs that ride on them: none is stirred or turns faster than those, so that they do not boil, and so that a pixel
// can add them to what a map holds of the others.
const int stirring_layers = 5;

// How strongly a layer of clouds is stirred, as flow_place takes it. strength: how strongly the coarse ones are.
float stirred(int layer, float strength) {
  return layer < stirring_layers ? strength : 0.0;
}

// How fast the gradients of a layer turn, as a multiple of the coarsest one's.
float flow_speed(int layer) {
  return exp2(float(min(layer, stirring_layers - 1)));
}

// What tells the noise of clouds from all other noise of a planet.
uint cloud_seed(int seed) {
  return uint(seed) + 5021u;
}

// How much more than elsewhere rises along the equator and at 60 degrees, and less at 30 degrees and the poles, -1..1. It
// is the cosine of six times the latitude. sine: of the latitude.
float cloud_belt(float sine) {
  float c = 1.0 - 2.0 * sine * sine;
  return c * (4.0 * c * c - 3.0);
}

// The noise that clouds are made from, about -1..1, from the sum of its layers. total: of their amplitudes; belts: how
// strongly they keep to belts; sine: of the latitude.
float cloud_noise_of(float sum, float total, float belts, float sine) {
  return sum / total + 0.22 * belts * cloud_belt(sine);
}

// Where a layer is asked for its noise, in its cells: the gradients of those before it (warp) stir it.
vec3 flow_place(vec3 direction, float frequency, float strength, vec3 warp, int layer, uint seed) {
  return direction * frequency + strength * warp + layer_offset(layer, seed);
}

// One layer at its place: returns its share and adds its gradient to the warp that stirs the next ones. turn: cosine and
// sine of the angle by which its gradients are turned.
float flow_layer(vec3 place, float amplitude, vec2 turn, int layer, uint seed, inout vec3 warp) {
  Noise n = turned_noise(ivec3(0), place, turn, layer_seed(layer, seed));
  warp += amplitude * n.gradient;
  return amplitude * n.value;
}

// The noise as a map without signs holds it, 0..1, and back. Noise passes its ends by a hundredth.
float noise_to_map(float noise) {
  return 0.5 + noise * (0.5 / 1.02);
}

float noise_from_map(float held) {
  return (held - 0.5) * (1.02 / 0.5);
}

// Thickness of the cloud, 0..1, from the noise at a place (its sum divided by the sum of amplitudes, -1..1). coverage:
// part of the sky that is covered, 0..1; softness 0..1.
float cloud_thickness(float noise, float coverage, float softness) {
  float threshold = 0.45 * (1.0 - 2.0 * coverage) - 0.12 * softness;
  float width = 0.03 + 0.55 * softness;
  float rise = clamp((noise - threshold) / width, 0.0, 1.0);
  return coverage <= 0.0 ? 0.0 : rise * rise * (3.0 - 2.0 * rise);
}
