#include "planet/milky_band.hpp"

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "formulas/formulas.hpp"
#include "planet/spiral.hpp"

namespace terrella {
namespace {

constexpr unsigned seed_of_band = 31'337;
// Over the whole sphere, of which the band takes a sixth.
constexpr int glow_places = 3000, star_places = 60'000;
constexpr float half_width = 0.17F;  // as a sine

unsigned seed_of(const Scene& scene) { return static_cast<unsigned>(scene.stars.seed) + seed_of_band; }

// How bright the band is at a direction, 0..1: clouds of stars, and dust that hides some along the middle.
class Band {
 public:
  explicit Band(const Scene& scene) : normal_(milky_band_normal(scene)), seed_(seed_of(scene)) {}

  [[nodiscard]] bool holds(const glm::vec3& direction) const {
    return std::fabs(glm::dot(direction, normal_)) < half_width;
  }

  [[nodiscard]] float brightness(const glm::vec3& direction) const {
    const float across = glm::dot(direction, normal_) / half_width;
    const float clouds = noise(direction, 2.5F, 0), veils = noise(direction, 8.0F, 1);
    const float shape = 1.0F - glm::smoothstep(0.1F, 1.0F, std::fabs(across) * (1.2F - 0.4F * clouds));
    const float dust = glm::smoothstep(0.05F, 0.45F, std::fabs(across + 0.35F * clouds) + 0.5F * veils);
    return shape * (0.45F + 0.55F * dust) * (0.75F + 0.35F * veils);
  }

 private:
  [[nodiscard]] float noise(const glm::vec3& direction, float frequency, unsigned which) const {
    return f32::simplex_noise(glm::ivec3(0), direction * frequency, seed_ + which).value;
  }

  glm::vec3 normal_;
  unsigned seed_;
};

// A place beside an even one, so that no spiral is seen.
glm::vec3 scattered(int i, int count, unsigned seed) {
  const glm::vec3 jitter = f32::hash_parts(f32::hash_cell(glm::ivec3(i, 1, 0), seed)) / 1023.0F - 0.5F;
  return glm::normalize(glm::vec3(spiral_direction(i, count)) + 2.6F / std::sqrt(static_cast<float>(count)) * jitter);
}

}  // namespace

glm::vec3 milky_band_normal(const Scene& scene) {
  // Tilted, each sky another way; that of the first passes behind the planet in the first view.
  constexpr double tilt = 0.95, first = 1.75, golden = 2.399963;
  const double longitude = first + golden * (scene.stars.seed - 1);
  return {std::sin(tilt) * std::cos(longitude), std::sin(tilt) * std::sin(longitude), std::cos(tilt)};
}

StarSky find_milky_band(const Scene& scene) {
  StarSky sky;
  if (scene.stars.band <= 0.0) return sky;
  const Band band(scene);
  const auto strength = static_cast<float>(scene.stars.band);
  for (int i = 0; i < glow_places; ++i) {
    const glm::vec3 direction = scattered(i, glow_places, seed_of(scene));
    if (!band.holds(direction)) continue;
    sky.noise_evaluations += 2;
    const float bright = strength * band.brightness(direction);
    if (bright < 0.02F) continue;
    sky.stars.push_back({direction, 0.075F * bright,
                         glm::mix(glm::vec3(1.0F, 0.86F, 0.72F), glm::vec3(0.72F, 0.84F, 1.1F), bright), 0.052F});
  }
  for (int i = 0; i < star_places; ++i) {
    const glm::vec3 direction = scattered(i, star_places, seed_of(scene) + 7);
    if (!band.holds(direction)) continue;
    sky.noise_evaluations += 2;
    const float dice = static_cast<float>(f32::hash_cell(glm::ivec3(i, 2, 0), seed_of(scene)) & 1023U) / 1023.0F;
    if (dice > strength * band.brightness(direction)) continue;
    sky.stars.push_back({direction, 0.03F + 0.10F * dice * dice, glm::vec3(1.0F, 0.95F, 0.9F), 0.0F});
  }
  return sky;
}

}  // namespace terrella
