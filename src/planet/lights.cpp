#include "planet/lights.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "formulas/formulas.hpp"
#include "planet/icosphere.hpp"
#include "planet/needs.hpp"
#include "planet/terrain.hpp"

namespace terrella {
namespace {

constexpr int most_places = 160'000;          // looked at, at full density
constexpr float regions_per_radius = 2.2F;    // clusters of towns
constexpr float towns_per_radius = 13.0F;     // clusters of lights
constexpr double lift = 4e-4;                 // planet radii over the mesh, which hides what lies in it
constexpr unsigned seed_of_lights = 60'013U;  // apart from all other noise of the planet

float noise(const glm::dvec3& direction, float frequency, unsigned seed) {
  return f32::simplex_noise(glm::ivec3(0), glm::vec3(direction) * frequency, seed).value;
}

// How readily someone lives at a height over the water (planet radii), 0..1.
double habitable(const Scene& scene, double height) {
  const double radius = scene.planet.radius, rock = scene.terrain.mountain_height / radius;
  if (height <= 0.0 || height >= rock) return 0.0;
  const double inland = height / rock;
  return 1.0 - inland;
}

}  // namespace

Lights find_lights(const Scene& scene) {
  Lights found;
  const auto seed = static_cast<unsigned>(scene.lights.seed) + seed_of_lights;
  const auto count = static_cast<int>(most_places * scene.lights.density);
  const double water = has_water(scene) ? scene.water.level / scene.planet.radius : 0.0;
  const double snow = std::sin(glm::radians(scene.terrain.snow_latitude));
  const f32::Terrain terrain = terrain_of(scene);
  const int level = ground_level(scene);
  // A spiral of evenly spaced directions: no pole and no seam.
  const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    if (std::fabs(z) > snow) continue;
    const double r = std::sqrt(1.0 - z * z);
    // Moved at random by as much as they are apart, so that no spiral is seen.
    const unsigned dice = f32::hash_cell(glm::ivec3(i, 0, 0), seed);
    const glm::dvec3 jitter = glm::dvec3(dice & 1023U, (dice >> 10) & 1023U, (dice >> 20) & 1023U) / 1023.0 - 0.5;
    const glm::dvec3 direction = glm::normalize(glm::dvec3(r * std::cos(golden * i), r * std::sin(golden * i), z) +
                                                6.0 / std::sqrt(count + 1.0) * jitter);
    found.noise_evaluations += 2;
    const float crowd =
        1.4F * noise(direction, regions_per_radius, seed) + noise(direction, towns_per_radius, seed + 1);
    if (crowd < 0.3F) continue;
    found.noise_evaluations += noise_per_height(scene);
    const double ground = ground_radius(terrain, direction, icosphere_edge(level));
    const double welcome = habitable(scene, ground - 1.0 - water);
    const auto brightness = static_cast<float>(welcome * std::min(1.0, 1.6 * crowd));
    if (brightness < 0.08F) continue;
    found.noise_evaluations += 3 * noise_per_height(scene);
    const double drawn = drawn_ground_radius(terrain, direction, level);
    found.lights.push_back({glm::vec3(direction * (std::max(ground, drawn) + lift)), brightness});
  }
  return found;
}

}  // namespace terrella
