#include "app/camera_control.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "formulas/formulas.hpp"
#include "planet/facing.hpp"

namespace terrella {
namespace {

constexpr double farthest = 1e4;       // clearance, planet radii
constexpr double drag_friction = 3.5;  // 1/s
constexpr double zoom_ease = 12.0;     // 1/s
constexpr double key_pixels = 420.0;   // a second
constexpr double key_zoom = 1.3;       // logarithm of the factor, a second
constexpr double key_turn = 50.0;      // degrees a second
constexpr double slowest = 4.0;        // pixels a second; below it the planet stands

double wrapped(double degrees) { return std::remainder(degrees, 360.0); }

// Moves the place under the camera along the sphere by angles to the right and ahead, and carries the heading along, so
// that the view does not turn: also over a pole.
void move_over(Scene& scene, double right_angle, double ahead_angle) {
  if (right_angle == 0.0 && ahead_angle == 0.0) return;
  set_facing(scene.camera, carried(facing_of(scene.camera), {right_angle, ahead_angle}));
}

// Angle over the ground of a pixel's width, as near the middle of the picture. Far away a drag over the whole picture
// turns the planet once at the most.
double ground_angle(const Pose& pose, const View& view) {
  const double steepness = -glm::dot(pose.forward, glm::normalize(pose.eye));
  const double distance = pose.clearance / std::max(0.4, steepness);
  return std::min(distance * pose.pixel_angle, 6.3 / view.height);
}

// The pitch that shows most at a height: down at the planet from afar, along the ground close by.
double natural_pitch(double clearance) {
  const double nearness = std::clamp(std::log(0.7 / clearance) / std::log(0.7 / 0.004), 0.0, 1.0);
  return -90.0 + 74.0 * nearness * nearness * (3.0 - 2.0 * nearness);
}

// Where a ray meets the sphere of the ground below the camera, as a unit vector; the place below the camera if nowhere.
glm::dvec3 ground_point(const Pose& pose, const glm::dvec3& ray) {
  const double radius = glm::length(pose.eye) - pose.clearance;
  const f64::Roots roots = f64::ray_sphere(pose.eye, ray, radius);
  return glm::normalize(pose.eye + std::max(roots.t0, 0.0) * ray);
}

}  // namespace

void CameraControl::drag(Scene& scene, const View& view, glm::dvec2 pixels) {
  const double angle = ground_angle(pose_of(scene, view), view);
  move_over(scene, -pixels.x * angle, pixels.y * angle);
  last_drag_ = pixels;
  velocity_ = {0.0, 0.0};
}

void CameraControl::release(double seconds) {
  velocity_ = seconds < 0.08 ? last_drag_ / std::max(seconds, 0.008) : glm::dvec2(0.0);
  const double speed = glm::length(velocity_);
  if (speed > 3000.0) velocity_ *= 3000.0 / speed;
  last_drag_ = {0.0, 0.0};
}

void CameraControl::look(Scene& scene, const View& view, glm::dvec2 pixels) {
  const double degrees = scene.camera.fov / std::min(view.width, view.height);
  scene.camera.heading = wrapped(scene.camera.heading + pixels.x * degrees);
  scene.camera.pitch = std::clamp(scene.camera.pitch - pixels.y * degrees, -90.0, 90.0);
}

void CameraControl::zoom(double factor, glm::dvec2 toward) {
  zoom_left_ = std::clamp(zoom_left_ + std::log(factor), -3.0, 3.0);
  zoom_toward_ = toward;
}

void CameraControl::zoom_now(Scene& scene, const View& view, double factor, glm::dvec2 toward) {
  const Pose pose = pose_of(scene, view);
  const double clearance = std::clamp(pose.clearance / factor, least_clearance(scene), farthest);
  const double share = 1.0 - clearance / pose.clearance;
  const glm::dvec3 place = glm::normalize(pose.eye);
  const glm::dvec3 target = ground_point(pose, ray_through(pose, view, toward));
  const double away = std::min(f64::angle_between(place, target), 1.0);
  if (away > 1e-9) {
    const Facing facing = facing_of(scene.camera);
    const glm::dvec3 toward_target = glm::normalize(target - glm::dot(target, place) * place);
    const double step = away * std::max(share, -0.5);
    move_over(scene, step * glm::dot(toward_target, right_of(facing)), step * glm::dot(toward_target, facing.ahead));
  }
  const double radius = scene.planet.radius;
  const double surface = glm::length(pose.eye) - pose.clearance;
  scene.camera.altitude = (surface + clearance - 1.0) * radius;
  scene.camera.pitch =
      std::clamp(scene.camera.pitch + natural_pitch(clearance) - natural_pitch(pose.clearance), -90.0, 90.0);
}

void CameraControl::roll(Scene& scene, double angle) {
  const double down = std::max(0.0, -std::sin(glm::radians(scene.camera.pitch)));
  scene.camera.heading = wrapped(scene.camera.heading - glm::degrees(angle) * down);
}

bool CameraControl::tick(Scene& scene, const View& view, double seconds) {
  const auto before = scene.camera;
  const double dt = std::min(seconds, 0.1);
  if (velocity_ != glm::dvec2(0.0)) {
    const double angle = ground_angle(pose_of(scene, view), view);
    move_over(scene, -velocity_.x * dt * angle, velocity_.y * dt * angle);
    velocity_ *= std::exp(-drag_friction * dt);
    if (glm::length(velocity_) < slowest) velocity_ = {0.0, 0.0};
  }
  if (push_.right != 0.0 || push_.ahead != 0.0) {
    const double angle = key_pixels * dt * ground_angle(pose_of(scene, view), view);
    move_over(scene, push_.right * angle, push_.ahead * angle);
  }
  double nearer = push_.nearer * key_zoom * dt;
  glm::dvec2 toward = glm::dvec2(0.5 * view.width, 0.5 * view.height) + view.shift;
  if (zoom_left_ != 0.0) {
    const double part = std::abs(zoom_left_) < 1e-3 ? zoom_left_ : zoom_left_ * (1.0 - std::exp(-zoom_ease * dt));
    zoom_left_ -= part;
    nearer += part;
    toward = zoom_toward_;
  }
  if (nearer != 0.0) zoom_now(scene, view, std::exp(nearer), toward);
  scene.camera.heading = wrapped(scene.camera.heading + push_.turn * key_turn * dt);
  scene.camera.pitch = std::clamp(scene.camera.pitch + push_.tilt * key_turn * dt, -90.0, 90.0);
  if (!(scene.camera == before)) {
    const Pose pose = pose_of(scene, view);
    if (pose.raised) scene.camera.altitude = (glm::length(pose.eye) - 1.0) * scene.planet.radius;
  }
  return !(scene.camera == before);
}

bool CameraControl::moving() const { return velocity_ != glm::dvec2(0.0) || zoom_left_ != 0.0 || push_ != Push{}; }

void CameraControl::stop() {
  velocity_ = last_drag_ = {0.0, 0.0};
  zoom_left_ = 0.0;
}

}  // namespace terrella
