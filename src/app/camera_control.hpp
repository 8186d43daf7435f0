// The hand on the camera: drags, wheels, pinches and keys become camera parameters, with inertia.
#pragma once

#include <glm/vec2.hpp>

#include "planet/pose.hpp"
#include "scene/scene.hpp"

namespace terrella {

class CameraControl {
 public:
  // Turns the planet under the camera by a drag of so many pixels. While held, later calls give it momentum.
  void drag(Scene& scene, const View& view, glm::dvec2 pixels);
  // Lets go after a drag: the planet turns on for a while. seconds: since the last drag call; a rest stops it.
  void release(double seconds);
  // Looks around: heading and pitch by a drag of so many pixels.
  void look(Scene& scene, const View& view, glm::dvec2 pixels);
  // Asks to come nearer by a factor above 1 (or to go away, below 1), towards a pixel. Done over the next ticks.
  void zoom(double factor, glm::dvec2 toward);
  // The same at once, as fingers do.
  void zoom_now(Scene& scene, const View& view, double factor, glm::dvec2 toward);
  // Turns the picture clockwise by an angle, rad, as two fingers do that twist: as far as the camera looks down. Level
  // with the horizon it stays, which a twist would only drag along.
  void roll(Scene& scene, double angle);
  // Which ways the held keys push, each -1..1: to the right, ahead, nearer, turn right, look up.
  struct Push {
    double right = 0.0, ahead = 0.0, nearer = 0.0, turn = 0.0, tilt = 0.0;
    bool operator==(const Push&) const = default;
  };
  void push(const Push& push) { push_ = push; }
  [[nodiscard]] bool pushed() const { return push_ != Push{}; }

  // Lets time pass (s, >= 0). Returns whether the camera moved.
  bool tick(Scene& scene, const View& view, double seconds);

  // Whether it will move on without a further touch.
  [[nodiscard]] bool moving() const;
  // Stops all inertia: the scene was replaced.
  void stop();

 private:
  glm::dvec2 velocity_{0.0};  // of the ground through the picture, pixels a second
  glm::dvec2 last_drag_{0.0};
  double zoom_left_ = 0.0;  // logarithm of the factor still to come
  glm::dvec2 zoom_toward_{0.0};
  Push push_;
};

}  // namespace terrella
