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
  squares_ = std::make_unique<gl::Squares>(data, 2);
}

void StarsNoise::draw(const Frame& frame) {
  program_.use();
  program_.set("picture_size", static_cast<float>(frame.view.width), static_cast<float>(frame.view.height));
  squares_->draw();
}

}  // namespace terrella
