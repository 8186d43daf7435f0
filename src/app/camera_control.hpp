// The hand on the camera: drags, wheels, pinches and keys become camera parameters, in one of three ways.
#pragma once

#include <glm/vec2.hpp>

#include "app/fly.hpp"
#include "app/fly_to.hpp"
#include "app/orbit.hpp"
#include "app/push.hpp"
#include "app/walk.hpp"
#include "panel/camera_mode.hpp"
#include "planet/pose.hpp"
#include "scene/scene.hpp"

namespace terrella {

class CameraControl {
 public:
  [[nodiscard]] CameraMode mode() const { return mode_; }
  // The camera stays where it is; what must become otherwise does so over the next ticks.
  void set_mode(CameraMode mode);

  // Flies to a place within a few seconds, whichever way hands move the camera, and looks there as it does here: as low
  // over the ground, the view lies as much nearer to the horizon. On foot, where no altitude is given, one comes to
  // stand. Any hand on the camera, and any other change of the scene, ends it where it is.
  void fly_to(const Scene& scene, const Destination& there);

  // A hand takes hold: in orbit the planet stands.
  void hold();
  // Turns the planet under the camera by a drag of so many pixels. While held, later calls give it momentum. In flight
  // and on foot it looks around.
  void drag(Scene& scene, const View& view, glm::dvec2 pixels);
  // Lets go after a drag: the planet turns on for a while. seconds: since the last drag call; a rest stops it.
  void release(double seconds) { orbit_.release(seconds); }
  // Looks around by a drag of so many pixels.
  void look(Scene& scene, const View& view, glm::dvec2 pixels);
  // Asks to come nearer by a factor above 1 (or to go away, below 1), towards a pixel. Done over the next ticks. In
  // flight it is the speed that changes.
  void zoom(double factor, glm::dvec2 toward);
  // The same at once, as fingers do. Feet stay on the ground.
  void zoom_now(Scene& scene, const View& view, double factor, glm::dvec2 toward);
  // Turns the picture clockwise by an angle, rad, as two fingers do that twist: as far as the camera looks down. Level
  // with the horizon it stays, which a twist would only drag along; but in flight it rolls.
  void roll(Scene& scene, double angle);
  // Which ways the held keys push.
  void push(const Push& push);
  [[nodiscard]] bool pushed() const { return pushes(push_); }

  // Lets time pass (s, >= 0). Returns whether the camera moved.
  bool tick(Scene& scene, const View& view, double seconds);

  // Whether it will move on without a further touch.
  [[nodiscard]] bool moving() const;
  // Stops all inertia.
  void stop();
  // Another scene is there. It is shown as it is: who walked and would fall in it, orbits again.
  void scene_replaced(const Scene& scene);

 private:
  CameraMode mode_ = CameraMode::orbit;
  Orbit orbit_;
  Fly fly_;
  Walk walk_;
  FlyTo fly_to_;
  Push push_;
};

}  // namespace terrella
