#include "app/camera_control.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "app/camera_frame.hpp"
#include "app/human.hpp"

namespace terrella {
namespace {

constexpr double longest_tick = 0.1;        // s
constexpr double longest_step = 1.0 / 120;  // s, of flight and walk: they look at the ground after each

// At least one step, if of no time: feet find their ground by it.
template <class Mover>
void in_steps(Mover& mover, Scene& scene, const Push& push, double seconds) {
  const int count = std::max(1, static_cast<int>(std::ceil(seconds / longest_step - 1e-6)));
  for (int i = 0; i < count; ++i) mover.step(scene, push, seconds / count);
}

}  // namespace

void CameraControl::set_mode(CameraMode mode) {
  fly_to_.stop();
  if (mode == mode_) return;
  mode_ = mode;
  stop();
}

void CameraControl::fly_to(const Scene& scene, const Destination& there) {
  stop();
  std::optional<double> clearance;
  if (mode_ == CameraMode::walk) clearance = eye_height(scene);
  fly_to_.start(scene, view_of_place(scene, there, clearance));
}

void CameraControl::hold() {
  fly_to_.stop();
  if (mode_ == CameraMode::orbit) orbit_.stop();
}

void CameraControl::drag(Scene& scene, const View& view, glm::dvec2 pixels) {
  fly_to_.stop();
  if (mode_ == CameraMode::orbit) return orbit_.drag(scene, view, pixels);
  look(scene, view, pixels);
}

void CameraControl::look(Scene& scene, const View& view, glm::dvec2 pixels) {
  fly_to_.stop();
  switch (mode_) {
    case CameraMode::orbit: return orbit_.look(scene, view, pixels);
    case CameraMode::fly: return Fly::look(scene, view, pixels);
    case CameraMode::walk: return terrella::look(scene, view, pixels);
  }
}

void CameraControl::zoom(double factor, glm::dvec2 toward) {
  fly_to_.stop();
  if (mode_ == CameraMode::orbit) orbit_.zoom(factor, toward);
  if (mode_ == CameraMode::fly) fly_.hasten(factor);
}

void CameraControl::zoom_now(Scene& scene, const View& view, double factor, glm::dvec2 toward) {
  fly_to_.stop();
  if (mode_ != CameraMode::walk) orbit_.zoom_now(scene, view, factor, toward);
}

void CameraControl::roll(Scene& scene, double angle) {
  fly_to_.stop();
  if (mode_ == CameraMode::fly) {
    scene.camera.roll = wrapped(scene.camera.roll - glm::degrees(angle));
    return;
  }
  const double down = std::max(0.0, -std::sin(glm::radians(scene.camera.pitch)));
  scene.camera.heading = wrapped(scene.camera.heading - glm::degrees(angle) * down);
}

void CameraControl::push(const Push& push) {
  push_ = push;
  if (pushed()) fly_to_.stop();
}

bool CameraControl::tick(Scene& scene, const View& view, double seconds) {
  const auto before = scene.camera;
  const double dt = std::min(seconds, longest_tick);
  if (fly_to_.moving()) {
    fly_to_.tick(scene, view, dt);
    return !(scene.camera == before);
  }
  switch (mode_) {
    case CameraMode::orbit: orbit_.tick(scene, view, push_, dt); break;
    case CameraMode::fly: in_steps(fly_, scene, push_, dt); break;
    case CameraMode::walk: in_steps(walk_, scene, push_, dt); break;
  }
  if (!(scene.camera == before)) keep_raised(scene, view);
  return !(scene.camera == before);
}

bool CameraControl::moving() const {
  if (pushed() || fly_to_.moving()) return true;
  switch (mode_) {
    case CameraMode::orbit: return orbit_.moving();
    case CameraMode::fly: return fly_.moving();
    case CameraMode::walk: return walk_.moving();
  }
  return false;
}

void CameraControl::stop() {
  fly_to_.stop();
  orbit_.stop();
  fly_.stop();
  walk_.stop();
}

void CameraControl::scene_replaced(const Scene& scene) {
  stop();
  if (mode_ == CameraMode::walk && !stands_on_ground(scene)) mode_ = CameraMode::orbit;
}

}  // namespace terrella
