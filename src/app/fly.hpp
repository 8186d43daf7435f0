// The camera in free flight, with six degrees of freedom. Level flight follows the planet's curve. The nearer the
// ground, the slower: to go as far as the ground is below takes as long at every height.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "app/push.hpp"
#include "planet/pose.hpp"
#include "scene/scene.hpp"

namespace terrella {

class Fly {
 public:
  // Looks around by a drag of so many pixels: over the top as well, from where on the flight is upside down.
  static void look(Scene& scene, const View& view, glm::dvec2 pixels);
  // Multiplies the speed, within bounds.
  void hasten(double factor);

  // dt: s; short enough that nothing turns far within it.
  void step(Scene& scene, const Push& push, double dt);
  [[nodiscard]] bool moving() const { return motion_ != glm::dvec3(0.0); }
  void stop() { motion_ = glm::dvec3(0.0); }

 private:
  glm::dvec3 motion_{0.0};  // to the camera's right, along its view, up from the planet; 1: as fast as it goes
  double pace_ = 1.0;
};

}  // namespace terrella
