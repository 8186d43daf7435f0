#include "planet/surface_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "planet/materials.hpp"
#include "planet/spheres.hpp"
#include "planet/terrain.hpp"

namespace terrella {
namespace {

constexpr double exposure = 1.25;  // of colours that the sun would light
constexpr double relief_contrast = 0.5;
constexpr double bare = 0.05;  // of what has neither ground nor sea

// How much a slope is lit or shaded: by how steep it is beside what is usual on this planet, as real mountains are too
// low to be seen on a map.
double lit(const glm::dvec3& gradient, const glm::dvec3& northwest, double usual) {
  return 1.0 - relief_contrast * glm::dot(gradient, northwest) / std::hypot(usual, glm::length(gradient));
}

}  // namespace

SurfaceMap::SurfaceMap(const Scene& scene, int height)
    : has_ground_(has_ground(scene)),
      has_water_(has_water(scene)),
      terrain_(exact_terrain_of(scene)),
      bands_(bands_of(scene)),
      look_(water_look_of(scene)),
      sea_(water_radius(scene) - 1.0),
      height_(height) {}

glm::dvec3 SurfaceMap::ground_at(const glm::dvec3& up, const f64::Height& height) const {
  const glm::dvec3 gradient = height.gradient - glm::dot(height.gradient, up) * up;
  const f64::GroundAt ground = {gradient, height.openness, height.value - (has_water_ ? sea_ : 0.0)};
  return f64::ground_albedo(up, ground, glm::normalize(up - gradient), bands_);
}

glm::dvec3 SurfaceMap::light_at(const glm::dvec3& up, const glm::dvec3& east) const {
  if (!has_ground_) return has_water_ ? look_.color : glm::dvec3(bare);
  const f64::Height height = f64::terrain_height_at(up, terrain_, std::numbers::pi / height_);
  const glm::dvec3 gradient = height.gradient - glm::dot(height.gradient, up) * up;
  const glm::dvec3 northwest = glm::normalize(glm::cross(up, east) - east);
  const glm::dvec3 ground = ground_at(up, height) * lit(gradient, northwest, terrain_.height * terrain_.frequency);
  const double depth = sea_ - height.value;
  if (!has_water_ || depth <= 0.0) return ground;
  const glm::dvec3 seen = glm::exp(-2.0 * depth * look_.extinction);
  return glm::mix(look_.color, ground, seen);
}

void SurfaceMap::make_row(int row, std::span<glm::vec4> colors) const {
  const double latitude = std::numbers::pi * (0.5 - (row + 0.5) / height_);
  const double turn = 2.0 * std::numbers::pi / static_cast<double>(colors.size());
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const double longitude = turn * (static_cast<double>(i) + 0.5) - std::numbers::pi;
    const glm::dvec3 east = {-std::sin(longitude), std::cos(longitude), 0.0};
    const glm::dvec3 up = {std::cos(latitude) * east.y, -std::cos(latitude) * east.x, std::sin(latitude)};
    colors[i] = glm::vec4(f64::srgb(exposure * light_at(up, east)), 1.0F);
  }
}

}  // namespace terrella
