#include "passes/stars_noise.hpp"

#include <vector>

#include "planet/stars.hpp"

namespace terrella {

void StarsNoise::update(const Frame& frame) {
  noise_evaluations_ = 0;
  const Key key = {frame.scene.stars.density, frame.scene.stars.seed};
  if (key_ == key) return;
  key_ = key;
  const StarSky sky = find_stars(frame.scene);
  noise_evaluations_ = sky.noise_evaluations;
  std::vector<float> data;
  data.reserve(sky.stars.size() * 8);
  for (const Star& star : sky.stars) {
    const glm::vec3 &d = star.direction, &c = star.color;
    data.insert(data.end(), {d.x, d.y, d.z, star.brightness, c.r, c.g, c.b, 0.0F});
  }
  points_ = std::make_unique<gl::Points>(data, 2);
}

void StarsNoise::draw() {
  program_.use();
  points_->draw();
}

}  // namespace terrella
