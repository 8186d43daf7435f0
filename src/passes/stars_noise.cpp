#include "passes/stars_noise.hpp"

#include <cmath>

#include <glm/geometric.hpp>

namespace terrella {
namespace {

// A cone around directions; all of space where the cosine is -1.
struct Cone {
  glm::vec3 axis;
  float cosine;
  [[nodiscard]] bool holds(const glm::vec3& direction) const { return glm::dot(axis, direction) >= cosine; }
};

// Around all that the picture shows.
Cone cone_of_picture(const Frame& frame) {
  const double half_angle =
      picture_half_angle(frame.pose, frame.view) + 0.06;  // stars are not points, and glows are wide
  return {glm::vec3(frame.pose.forward), static_cast<float>(std::cos(half_angle))};
}

// Within what the planet hides.
Cone cone_of_planet(const Frame& frame) {
  const double solid = solid_radius(frame.needs), distance = glm::length(frame.pose.eye);
  const double sine = distance > solid ? solid / distance : 0.0;
  return {glm::vec3(-frame.pose.eye / distance), sine > 0.0 ? static_cast<float>(std::sqrt(1.0 - sine * sine)) : 2.0F};
}

}  // namespace

void StarsNoise::update(const Frame& frame) {
  noise_evaluations_ = 0;
  const Key key = {frame.scene.stars.density, frame.scene.stars.band, frame.scene.stars.seed};
  if (key_ == key) return;
  // The search takes as long as a frame: the first pictures come without stars.
  if (!program_.ready(frame.effort == Effort::complete)) return;
  key_ = key;
  StarSky sky = find_stars(frame.scene);
  noise_evaluations_ = sky.noise_evaluations;
  stars_ = std::move(sky.stars);
  StarSky band = find_milky_band(frame.scene);
  noise_evaluations_ += band.noise_evaluations;
  stars_.insert(stars_.end(), band.stars.begin(), band.stars.end());
  squares_.forget();
}

std::vector<std::size_t> StarsNoise::choose(const Frame& frame) const {
  const Cone picture = cone_of_picture(frame), planet = cone_of_planet(frame);
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < stars_.size(); ++i) {
    if (picture.holds(stars_[i].direction) && !planet.holds(stars_[i].direction)) shown.push_back(i);
  }
  return shown;
}

void StarsNoise::draw(const Frame& frame) {
  if (!key_) return;
  program_->use();
  program_->set("picture_size", static_cast<float>(frame.view.width), static_cast<float>(frame.view.height));
  squares_.draw(choose(frame), [&](std::size_t i, std::vector<float>& data) {
    const glm::vec3 &d = stars_[i].direction, &c = stars_[i].color;
    data.insert(data.end(), {d.x, d.y, d.z, stars_[i].brightness, c.r, c.g, c.b, stars_[i].radius});
  });
}

}  // namespace terrella
