// The camera on foot: with gravity, at the height of eyes over ground or sea (see human.hpp).
#pragma once

#include <glm/vec2.hpp>

#include "app/push.hpp"
#include "planet/pose.hpp"
#include "scene/scene.hpp"

namespace terrella {

class Walk {
 public:
  // dt: s; short enough that a step within it is small beside a stride.
  void step(Scene& scene, const Push& push, double dt);
  // Whether it moves on without a push.
  [[nodiscard]] bool moving() const { return !stands_; }
  // Forgets all momentum. Whether the feet have ground under them, the next step finds out.
  void stop() { *this = {}; }

 private:
  // metre: planet radii of one of people (human.hpp).
  glm::dvec2 gather_way(const Push& push, double metre, double dt);
  double fall(Scene& scene, double height, double metre, double dt);
  void land();

  glm::dvec2 velocity_{0.0};  // to the right and ahead, planet radii a second
  double rising_ = 0.0;       // by gravity and jumps, planet radii a second
  double haste_ = 0.0;        // 0..1: part of what a fall from high up is hastened by, so that it begins gently
  bool from_high_ = false;    // the fall began where it is hastened
  bool stands_ = false;
};

// Whether someone on foot could stand where the camera is.
bool stands_on_ground(const Scene& scene);

}  // namespace terrella
