#include "planet/lights.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "formulas/formulas.hpp"
#include "planet/icosphere.hpp"
#include "planet/spiral.hpp"
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
  return 1.0 - height / rock;
}

}  // namespace

bool has_lights(const Scene& scene) {
  return has_ground(scene) && scene.lights.density > 0.0 && scene.lights.brightness > 0.0;
}

Lights find_lights(const Scene& scene, int level) {
  Lights found;
  const auto seed = static_cast<unsigned>(scene.lights.seed) + seed_of_lights;
  const auto count = static_cast<int>(most_places * scene.lights.density);
  const double water = water_level(scene) / scene.planet.radius;
  const double edge = icosphere_edge(level);
  const int noise_each = noise_per_height(scene, edge);
  const double cold = std::sin(glm::radians(std::min(scene.terrain.snow_latitude, scene.water.ice_latitude)));
  const f32::Terrain terrain = terrain_of(scene);
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 even = spiral_direction(i, count);
    if (std::fabs(even.z) > cold) continue;
    // Moved at random by as much as they are apart, so that no spiral is seen.
    const glm::dvec3 jitter = f64::hash_parts(f64::hash_cell(glm::ivec3(i, 0, 0), seed)) / 1023.0 - 0.5;
    const glm::dvec3 direction = glm::normalize(even + 6.0 / std::sqrt(count + 1.0) * jitter);
    found.noise_evaluations += 2;
    const float crowd =
        1.4F * noise(direction, regions_per_radius, seed) + noise(direction, towns_per_radius, seed + 1);
    if (crowd < 0.3F) continue;
    found.noise_evaluations += noise_each;
    const double ground = ground_radius(terrain, direction, edge);
    const double welcome = habitable(scene, ground - 1.0 - water);
    const auto brightness = static_cast<float>(welcome * std::min(1.0, 1.6 * crowd));
    if (brightness < 0.08F) continue;
    found.noise_evaluations += 3 * noise_each;
    const double drawn = drawn_ground_radius(terrain, direction, level);
    found.lights.push_back({glm::vec3(direction * (std::max(ground, drawn) + lift)), brightness});
  }
  return found;
}

}  // namespace terrella
