#include "reference/small_lights.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "planet/lights.hpp"
#include "planet/linear_color.hpp"
#include "planet/materials.hpp"
#include "planet/milky_band.hpp"
#include "planet/needs.hpp"
#include "planet/stars.hpp"
#include "planet/terrain.hpp"

namespace terrella::reference {
namespace {

constexpr int cell = 16;            // pixels
constexpr double disc_reach = 2.0;  // radii, of soft_disc

}  // namespace

SmallLights::SmallLights(const Scene& scene, const View& view, const Pose& pose, const f64::SceneLight& light)
    : view_(view), pose_(pose) {
  if (has_stars(scene)) {
    for (const StarSky& sky : {find_stars(scene), find_band_stars(scene)}) {
      for (const Star& star : sky.stars) {
        const glm::dvec3 direction(star.direction);
        const double brightness = double{star.brightness};
        add(direction, std::numeric_limits<double>::infinity(), f64::star_radius(scene.stars.size, brightness),
            f64::star_light(glm::dvec3(star.color), brightness, scene.stars.brightness) *
                f64::sky_shown(direction, light));
      }
    }
  }
  if (has_lights(scene)) {
    for (const Light& town : find_lights(scene, ground_level(scene)).lights) {
      const glm::dvec3 place(town.position), offset = place - pose.eye;
      if (glm::dot(offset, place) >= 0.0) continue;  // beyond the horizon
      const f64::TownLight seen = f64::town_light(place, offset, double{town.brightness}, linear(scene.lights.color),
                                                  scene.lights.brightness, pose.pixel_angle, light);
      // The ground that it stands on does not hide it.
      const double nearer = std::max(1.0 - 0.004 / glm::length(offset), 0.5);
      add(offset, nearer * glm::dot(offset, pose.forward), seen.radius, seen.light);
    }
  }
  sort_into_cells();
}

void SmallLights::add(const glm::dvec3& offset, double depth, double radius, const glm::dvec3& light) {
  const double ahead = glm::dot(offset, pose_.forward);
  if (ahead <= 0.0 || light == glm::dvec3(0.0)) return;
  const double scale = 0.5 * view_.height / (pose_.tan_half_fov * ahead);
  discs_.push_back({0.5 * glm::dvec2(view_.width, view_.height) + view_.shift +
                        scale * glm::dvec2(glm::dot(offset, pose_.right), -glm::dot(offset, pose_.up)),
                    radius, depth, light});
}

void SmallLights::sort_into_cells() {
  columns_ = (view_.width + cell - 1) / cell;
  rows_ = (view_.height + cell - 1) / cell;
  cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  const auto cell_of = [](double pixel, int count) {
    return static_cast<int>(std::floor(std::clamp(pixel / cell, -1.0, static_cast<double>(count))));
  };
  for (std::size_t i = 0; i < discs_.size(); ++i) {
    const auto& [pixel, radius, depth, light] = discs_[i];
    const double reach = disc_reach * radius;
    for (int y = std::max(0, cell_of(pixel.y - reach, rows_));
         y <= std::min(rows_ - 1, cell_of(pixel.y + reach, rows_)); ++y) {
      for (int x = std::max(0, cell_of(pixel.x - reach, columns_));
           x <= std::min(columns_ - 1, cell_of(pixel.x + reach, columns_)); ++x) {
        cells_[static_cast<std::size_t>(y * columns_ + x)].push_back(i);
      }
    }
  }
}

glm::dvec3 SmallLights::at(const glm::dvec2& pixel, double depth) const {
  const int x = std::clamp(static_cast<int>(pixel.x) / cell, 0, columns_ - 1);
  const int y = std::clamp(static_cast<int>(pixel.y) / cell, 0, rows_ - 1);
  glm::dvec3 sum(0.0);
  for (const std::size_t i : cells_[static_cast<std::size_t>(y * columns_ + x)]) {
    const Disc& disc = discs_[i];
    if (disc.depth > depth) continue;
    const glm::dvec2 away = (pixel - disc.pixel) / disc.radius;
    sum += disc.light * f64::soft_disc(glm::dot(away, away));
  }
  return sum;
}

}  // namespace terrella::reference
