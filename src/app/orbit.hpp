// The camera around the planet: a hand turns the planet under it and brings it nearer, with inertia.
#pragma once

#include <glm/vec2.hpp>

#include "app/push.hpp"
#include "planet/pose.hpp"
#include "scene/scene.hpp"

namespace terrella {

class Orbit {
 public:
  // What CameraControl says of them.
  void drag(Scene& scene, const View& view, glm::dvec2 pixels);
  void release(double seconds);
  void look(Scene& scene, const View& view, glm::dvec2 pixels);
  void zoom(double factor, glm::dvec2 toward);
  void zoom_now(Scene& scene, const View& view, double factor, glm::dvec2 toward);

  // dt: s, 0..0.1.
  void tick(Scene& scene, const View& view, const Push& push, double dt);
  [[nodiscard]] bool moving() const;
  void stop();

 private:
  glm::dvec2 velocity_{0.0};  // of the ground through the picture, pixels a second
  glm::dvec2 last_drag_{0.0};
  double zoom_left_ = 0.0;  // logarithm of the factor still to come
  glm::dvec2 zoom_toward_{0.0};
  bool levels_ = false;  // a hand has moved the camera: it takes back a roll that a flight or a scene has left
};

}  // namespace terrella
