#include "passes/stars_noise.hpp"

#include "passes/sky_view.hpp"

namespace terrella {

void StarsNoise::update(const Frame& frame) {
  noise_evaluations_ = 0;
  const Key key = {frame.scene.stars.density, frame.scene.stars.band, frame.scene.stars.seed};
  if (key_ == key) return;
  // The search takes as long as a frame: the first pictures come without stars.
  const bool patient = frame.effort == Effort::complete;
  if (!program_.ready(patient) || (key.band > 0.0 && !glow_.ready(patient))) return;
  key_ = key;
  StarSky sky = find_stars(frame.scene);
  noise_evaluations_ = sky.noise_evaluations;
  stars_ = std::move(sky.stars);
  StarSky band = find_band_stars(frame.scene);
  noise_evaluations_ += band.noise_evaluations;
  stars_.insert(stars_.end(), band.stars.begin(), band.stars.end());
  squares_.forget();
  glow_.set(frame.scene);
  noise_evaluations_ += glow_.noise_evaluations();
}

Chosen StarsNoise::choose(const Frame& frame) const {
  const SkyView view(frame);
  Chosen shown;
  for (std::uint32_t i = 0; i < stars_.size(); ++i) {
    if (view.within_picture(stars_[i].direction) && !view.behind_planet(stars_[i].direction)) shown.push_back(i);
  }
  return shown;
}

void StarsNoise::draw(const Frame& frame) {
  if (!key_) return;
  program_->use();
  program_->set("picture_size", static_cast<float>(frame.view.width), static_cast<float>(frame.view.height));
  squares_.draw(frame, choose(frame), [&](std::size_t i, std::vector<float>& data) {
    const glm::vec3 &d = stars_[i].direction, &c = stars_[i].color;
    data.insert(data.end(), {d.x, d.y, d.z, stars_[i].brightness, c.r, c.g, c.b, 0.0F});
  });
  glow_.draw(frame);
}

}  // namespace terrella
