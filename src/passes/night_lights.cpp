#include "passes/night_lights.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

#include "formulas/formulas.hpp"
#include "planet/terrain.hpp"

namespace terrella {

void NightLights::update(const Frame& frame) {
  noise_evaluations_ = 0;
  const Scene& scene = frame.scene;
  const Key key = {{scene.planet, scene.terrain, water_level(scene), scene.water.ice_latitude, scene.lights.density,
                    scene.lights.seed},
                   ground_level(scene)};
  // From one fineness of the ground to another lights move by less than is seen, and to find them takes long.
  const bool exactly = frame.effort == Effort::complete;
  settled_ = key_ && key_->places == key.places && (!exactly || key_->ground_level == key.ground_level);
  const bool changing = wanted_ != key;
  wanted_ = key;
  // The search takes longer than a frame: it waits until the ground has stood still for one.
  if (settled_ || frame.effort == Effort::hurried || (changing && frame.effort == Effort::live)) return;
  if (!program_.ready(frame.effort == Effort::complete)) return;
  found_ = find_lights(scene, key.ground_level);
  noise_evaluations_ = found_.noise_evaluations;
  squares_.forget();
  key_ = key;
  settled_ = true;
}

void NightLights::draw(const Frame& frame) {
  // Those of a mesh of another fineness stand in: they are in the same places, a little higher or lower.
  if (!key_ || key_->places != wanted_->places) return;
  const glm::vec3 eye(frame.pose.eye), sun(direction_of(frame.scene.sun.latitude, frame.scene.sun.longitude));
  const auto sides = sides_of(frame.pose, frame.view, frame.rows, margin_of_rows(frame));
  const glm::vec3 low(sides[0]), high(sides[1]);
  constexpr float widest = 0.0035F;  // half of a light's square, radii: twice town_light's radius, and some
  Chosen chosen;
  for (std::uint32_t i = 0; i < found_.lights.size(); ++i) {
    const glm::vec3& place = found_.lights[i].position;
    const bool in_rows = std::min(glm::dot(low, place - eye), glm::dot(high, place - eye)) >= -widest;
    if (in_rows && glm::dot(place, sun) < f32::lights_on && glm::dot(place, eye - place) > 0.0F) chosen.push_back(i);
  }
  program_->use();
  program_->set("picture_size", static_cast<float>(frame.view.width), static_cast<float>(frame.view.height));
  squares_.draw(frame, std::move(chosen), [&](std::size_t i, std::vector<float>& data) {
    const auto& [place, brightness] = found_.lights[i];
    data.insert(data.end(), {place.x, place.y, place.z, brightness});
  });
}

}  // namespace terrella
