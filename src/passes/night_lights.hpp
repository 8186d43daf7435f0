// The lights of the night side as small squares on the ground, found once for a ground (planet/lights.hpp); only those
// in the dark and in view are drawn.
#pragma once

#include <optional>

#include "gl/late_program.hpp"
#include "passes/chosen_squares.hpp"
#include "passes/frame.hpp"
#include "planet/lights.hpp"

namespace terrella {

class NightLights {
 public:
  // Finds the lights once their program is there and the hand rests; until then there are none.
  void update(const Frame& frame);
  void draw(const Frame& frame);
  [[nodiscard]] bool settled() const { return settled_; }
  [[nodiscard]] std::int64_t noise_evaluations() const { return noise_evaluations_; }

 private:
  struct Places {
    decltype(Scene::planet) planet;
    decltype(Scene::terrain) terrain;
    double water_level, ice_latitude;
    double density;
    int seed;
    bool operator==(const Places&) const = default;
  };
  struct Key {
    Places places;
    int ground_level;
    bool operator==(const Key&) const = default;
  };

  gl::LateProgram program_{"lights/night"};
  std::optional<Key> key_, wanted_;  // of the lights found, and of the last frame
  bool settled_ = false;
  Lights found_;
  ChosenSquares squares_{1};
  std::int64_t noise_evaluations_ = 0;
};

}  // namespace terrella
