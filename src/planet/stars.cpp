#include "planet/stars.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "formulas/formulas.hpp"
#include "planet/spiral.hpp"

namespace terrella {
namespace {

// Cells per radian of the noise whose peaks are the stars.
constexpr double frequency = 46.0;
// Samples per cell of the search, and how much of a cell a sample lies from a peak at the most.
constexpr double samples_per_cell = 1.6;
// The threshold at full and at no density. P(n > 0.6) is a hundredth or so (tests/laws/noise_test.cpp).
constexpr float threshold_dense = 0.52F;
constexpr float threshold_sparse = 0.86F;

f32::Noise noise_at(const glm::vec3& direction, unsigned seed) {
  return f32::simplex_noise(glm::ivec3(0), direction * static_cast<float>(frequency), seed);
}

}  // namespace

StarSky find_stars(const Scene& scene) {
  StarSky sky;
  const auto seed = static_cast<unsigned>(scene.stars.seed) + 977U;
  const float threshold = glm::mix(threshold_sparse, threshold_dense, static_cast<float>(scene.stars.density));
  const double step = 1.0 / (frequency * samples_per_cell);
  const auto count = static_cast<int>(4.0 * std::numbers::pi / (step * step));
  std::vector<glm::vec3> found;
  for (int i = 0; i < count && scene.stars.density > 0.0; ++i) {
    glm::vec3 direction(spiral_direction(i, count));
    f32::Noise n = noise_at(direction, seed);
    ++sky.noise_evaluations;
    if (n.value < 0.62F * threshold) continue;
    for (int climb = 0; climb < 4; ++climb) {
      const glm::vec3 uphill = n.gradient - glm::dot(n.gradient, direction) * direction;
      direction = glm::normalize(direction + uphill * static_cast<float>(0.045 / frequency));
      n = noise_at(direction, seed);
      ++sky.noise_evaluations;
    }
    if (n.value < threshold) continue;
    const uint32_t dice = f32::hash_cell(glm::ivec3(direction * 200.0F), seed);
    const float warmth =
        std::pow(static_cast<float>(dice & 1023U) / 1023.0F, 1.5F) * ((dice & 1024U) != 0U ? 1.F : -1.F);
    const float peak = glm::smoothstep(threshold - 0.02F, 1.0F, n.value);
    sky.stars.push_back({direction, peak * peak, f32::star_color(warmth)});
  }
  // Several samples climb to one peak: keep one star of those that stand together.
  std::sort(sky.stars.begin(), sky.stars.end(),
            [](const Star& a, const Star& b) { return a.direction.z < b.direction.z; });
  std::vector<Star> apart;
  const float near = static_cast<float>(0.6 / frequency);
  for (const Star& star : sky.stars) {
    bool alone = true;
    for (auto other = apart.rbegin(); other != apart.rend() && star.direction.z - other->direction.z < near; ++other) {
      if (glm::distance(star.direction, other->direction) < near) alone = false;
    }
    if (alone) apart.push_back(star);
  }
  sky.stars = std::move(apart);
  return sky;
}

}  // namespace terrella
