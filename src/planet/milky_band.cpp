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
// Squares of the glow along the band and over its width.
constexpr int columns = 300, rows = 20;

unsigned seed_of(const Scene& scene) { return static_cast<unsigned>(scene.stars.seed) + seed_of_band; }

// Evaluations of noise in one brightness.
constexpr int noise_each = 3;

// A place beside an even one, so that no spiral is seen.
glm::vec3 scattered(int i, int count, unsigned seed) {
  const glm::vec3 jitter = f32::hash_parts(f32::hash_cell(glm::ivec3(i, 1, 0), seed)) / 1023.0F - 0.5F;
  return glm::normalize(glm::vec3(spiral_direction(i, count)) + 2.6F / std::sqrt(static_cast<float>(count)) * jitter);
}

}  // namespace

glm::dvec3 milky_band_normal(const Scene& scene) {
  // Tilted, each sky another way; that of the first passes behind the planet in the first view.
  constexpr double tilt = 0.95, first = 1.75, golden = 2.399963;
  const double longitude = first + golden * (scene.stars.seed - 1);
  return {std::sin(tilt) * std::cos(longitude), std::sin(tilt) * std::sin(longitude), std::cos(tilt)};
}

double milky_band_brightness(const Scene& scene, const glm::dvec3& direction) {
  return scene.stars.band * f64::band_brightness(direction, milky_band_normal(scene), seed_of(scene));
}

StarSky find_band_stars(const Scene& scene) {
  StarSky sky;
  if (scene.stars.band <= 0.0) return sky;
  const glm::vec3 normal(milky_band_normal(scene));
  const auto strength = static_cast<float>(scene.stars.band);
  for (int i = 0; i < star_places; ++i) {
    const glm::vec3 direction = scattered(i, star_places, seed_of(scene) + 7);
    if (std::fabs(glm::dot(direction, normal)) >= f32::band_half_width) continue;
    sky.noise_evaluations += noise_each;
    const float dice = static_cast<float>(f32::hash_cell(glm::ivec3(i, 2, 0), seed_of(scene)) & 1023U) / 1023.0F;
    if (dice > strength * f32::band_brightness(direction, normal, seed_of(scene))) continue;
    sky.stars.push_back({direction, 0.03F + 0.10F * dice * dice, glm::vec3(1.0F, 0.95F, 0.9F)});
  }
  return sky;
}

BandGlow find_band_glow(const Scene& scene) {
  BandGlow glow;
  if (scene.stars.band <= 0.0) return glow;
  const auto strength = static_cast<float>(scene.stars.band);
  const glm::dvec3 normal(milky_band_normal(scene));
  const glm::dvec3 first = glm::normalize(glm::cross(normal, glm::dvec3(1.0, 0.0, 0.0)));
  const glm::dvec3 second = glm::cross(normal, first);
  for (int column = 0; column < columns; ++column) {
    const double turn = 2.0 * std::numbers::pi * column / columns;
    const glm::dvec3 along = std::cos(turn) * first + std::sin(turn) * second;
    for (int row = 0; row <= rows; ++row) {
      const double across = f64::band_half_width * (2.0 * row / rows - 1.0);
      const glm::vec3 direction(across * normal + std::sqrt(1.0 - across * across) * along);
      // Nothing is left at its edges.
      const float bright = row == 0 || row == rows
                               ? 0.0F
                               : strength * f32::band_brightness(direction, glm::vec3(normal), seed_of(scene));
      glow.vertices.push_back(direction * (1.0F + bright));
    }
  }
  glow.noise_evaluations = noise_each * static_cast<std::int64_t>(glow.vertices.size());
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
