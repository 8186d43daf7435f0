#include "planet/milky_band.hpp"

#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "formulas/formulas.hpp"
#include "planet/spiral.hpp"

namespace terrella {
namespace {

constexpr unsigned seed_of_band = 31'337;
// Over the whole sphere, of which the band takes a sixth.
constexpr int star_places = 60'000;
constexpr float half_width = 0.2F;  // as a sine
// Squares of the glow along the band and over its width.
constexpr int columns = 300, rows = 20;

unsigned seed_of(const Scene& scene) { return static_cast<unsigned>(scene.stars.seed) + seed_of_band; }

// How bright the band is at a direction, 0..1: clouds of stars, and dust that hides some along the middle.
class Band {
 public:
  static constexpr int noise_each = 3;

  explicit Band(const Scene& scene) : normal_(milky_band_normal(scene)), seed_(seed_of(scene)) {}

  [[nodiscard]] bool holds(const glm::vec3& direction) const {
    return std::fabs(glm::dot(direction, normal_)) < half_width;
  }

  [[nodiscard]] float brightness(const glm::vec3& direction) const {
    const float across = glm::dot(direction, normal_) / half_width;
    const float clouds = noise(direction, 2.5F, 0), veils = noise(direction, 7.0F, 1),
                wisps = noise(direction, 15.0F, 2);
    const float edge = std::fabs(across) * (1.25F - 0.25F * clouds - 0.2F * veils);
    const float shape = 1.0F - glm::smoothstep(0.0F, 1.0F, edge);
    const float from_dust = std::fabs(across + 0.22F * clouds + 0.1F * wisps) + 0.3F * veils + 0.12F * wisps;
    const float clear = glm::smoothstep(-0.05F, 0.3F, from_dust);
    return shape * (0.3F + 0.7F * clear) * (0.75F + 0.2F * clouds + 0.25F * veils + 0.15F * wisps);
  }

 private:
  // Drawn out along the band.
  [[nodiscard]] float noise(const glm::vec3& direction, float frequency, unsigned which) const {
    const glm::vec3 place = direction + 1.2F * glm::dot(direction, normal_) * normal_;
    return f32::simplex_noise(glm::ivec3(0), frequency * place, seed_ + which).value;
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

StarSky find_band_stars(const Scene& scene) {
  StarSky sky;
  if (scene.stars.band <= 0.0) return sky;
  const Band band(scene);
  const auto strength = static_cast<float>(scene.stars.band);
  for (int i = 0; i < star_places; ++i) {
    const glm::vec3 direction = scattered(i, star_places, seed_of(scene) + 7);
    if (!band.holds(direction)) continue;
    sky.noise_evaluations += Band::noise_each;
    const float dice = static_cast<float>(f32::hash_cell(glm::ivec3(i, 2, 0), seed_of(scene)) & 1023U) / 1023.0F;
    if (dice > strength * band.brightness(direction)) continue;
    sky.stars.push_back({direction, 0.03F + 0.10F * dice * dice, glm::vec3(1.0F, 0.95F, 0.9F)});
  }
  return sky;
}

BandGlow find_band_glow(const Scene& scene) {
  BandGlow glow;
  if (scene.stars.band <= 0.0) return glow;
  const Band band(scene);
  const auto strength = static_cast<float>(scene.stars.band);
  const glm::dvec3 normal(milky_band_normal(scene));
  const glm::dvec3 first = glm::normalize(glm::cross(normal, glm::dvec3(1.0, 0.0, 0.0)));
  const glm::dvec3 second = glm::cross(normal, first);
  for (int column = 0; column < columns; ++column) {
    const double turn = 2.0 * std::numbers::pi * column / columns;
    const glm::dvec3 along = std::cos(turn) * first + std::sin(turn) * second;
    for (int row = 0; row <= rows; ++row) {
      const double across = half_width * (2.0 * row / rows - 1.0);
      const glm::vec3 direction(across * normal + std::sqrt(1.0 - across * across) * along);
      // Nothing is left at its edges.
      const float bright = row == 0 || row == rows ? 0.0F : strength * band.brightness(direction);
      glow.vertices.push_back(direction * (1.0F + bright));
    }
  }
  glow.noise_evaluations = Band::noise_each * static_cast<std::int64_t>(glow.vertices.size());
  // Nobody would see it.
  const auto dark = [&](std::uint32_t vertex) { return glm::length(glow.vertices[vertex]) < 1.004F; };
  for (int column = 0; column < columns; ++column) {
    for (int row = 0; row < rows; ++row) {
      const auto a = static_cast<std::uint32_t>(column * (rows + 1) + row);
      const auto b = static_cast<std::uint32_t>((column + 1) % columns * (rows + 1) + row);
      if (dark(a) && dark(b) && dark(a + 1) && dark(b + 1)) continue;
      glow.indices.insert(glow.indices.end(), {a, b, a + 1, a + 1, b, b + 1});
    }
  }
  return glow;
}

}  // namespace terrella
