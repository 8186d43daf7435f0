#include "app/orbit.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "app/camera_frame.hpp"
#include "formulas/formulas.hpp"

namespace terrella {
namespace {

constexpr double drag_friction = 3.5;  // 1/s
constexpr double zoom_ease = 12.0;     // 1/s
constexpr double key_pixels = 420.0;   // a second
constexpr double key_zoom = 1.3;       // logarithm of the factor, a second
constexpr double key_turn = 50.0;      // degrees a second
constexpr double slowest = 4.0;        // pixels a second; below it the planet stands
constexpr double levelling = 1.0;      // s

// Angle over the ground of a pixel's width, as near the middle of the picture. Far away a drag over the whole picture
// turns the planet once at the most.
double ground_angle(const Pose& pose, const View& view) {
  const double steepness = -glm::dot(pose.forward, glm::normalize(pose.eye));
  const double distance = pose.clearance / std::max(0.4, steepness);
  return std::min(distance * pose.pixel_angle, 6.3 / view.height);
}

// Where a ray meets the sphere of the ground below the camera, as a unit vector; the place below the camera if nowhere.
glm::dvec3 ground_point(const Pose& pose, const glm::dvec3& ray) {
  const double radius = glm::length(pose.eye) - pose.clearance;
  const f64::Roots roots = f64::ray_sphere(pose.eye, ray, radius);
  return glm::normalize(pose.eye + std::max(roots.t0, 0.0) * ray);
}

void drag_ground(Scene& scene, const View& view, glm::dvec2 pixels) {
  const double angle = ground_angle(pose_of(scene, view), view);
  const glm::dvec2 over = angle * levelled(scene, pixels);
  move_over(scene, -over.x, over.y);
}

}  // namespace

void Orbit::drag(Scene& scene, const View& view, glm::dvec2 pixels) {
  drag_ground(scene, view, pixels);
  last_drag_ = pixels;
  velocity_ = {0.0, 0.0};
  levels_ = scene.camera.roll != 0.0;
}

void Orbit::release(double seconds) {
  velocity_ = seconds < 0.08 ? last_drag_ / std::max(seconds, 0.008) : glm::dvec2(0.0);
  const double speed = glm::length(velocity_);
  if (speed > 3000.0) velocity_ *= 3000.0 / speed;
  last_drag_ = {0.0, 0.0};
}

void Orbit::look(Scene& scene, const View& view, glm::dvec2 pixels) {
  terrella::look(scene, view, pixels);
  levels_ = scene.camera.roll != 0.0;
}

void Orbit::zoom(double factor, glm::dvec2 toward) {
  zoom_left_ = std::clamp(zoom_left_ + std::log(factor), -3.0, 3.0);
  zoom_toward_ = toward;
}

void Orbit::zoom_now(Scene& scene, const View& view, double factor, glm::dvec2 toward) {
  const Pose pose = pose_of(scene, view);
  const double clearance = std::clamp(pose.clearance / factor, least_clearance(scene), farthest);
  const double share = 1.0 - clearance / pose.clearance;
  const Facing facing = facing_of(scene.camera);
  const glm::dvec3 target = ground_point(pose, ray_through(pose, view, toward));
  const double away = std::min(f64::angle_between(facing.place, target), 1.0);
  if (away > 1e-9) {
    const glm::dvec3 toward_target = glm::normalize(target - glm::dot(target, facing.place) * facing.place);
    const double step = away * std::max(share, -0.5);
    move_over(scene, step * glm::dot(toward_target, right_of(facing)), step * glm::dot(toward_target, facing.ahead));
  }
  set_distance(scene, glm::length(pose.eye) - pose.clearance + clearance);
  terrella::look(scene, 0.0, natural_pitch(clearance) - natural_pitch(pose.clearance));
  levels_ = scene.camera.roll != 0.0;
}

void Orbit::tick(Scene& scene, const View& view, const Push& push, double dt) {
  if (velocity_ != glm::dvec2(0.0)) {
    drag_ground(scene, view, dt * velocity_);
    velocity_ *= std::exp(-drag_friction * dt);
    if (glm::length(velocity_) < slowest) velocity_ = {0.0, 0.0};
  }
  if (push.right != 0.0 || push.ahead != 0.0) {
    drag_ground(scene, view, key_pixels * dt * glm::dvec2(-push.right, push.ahead));
  }
  double nearer = push.nearer * key_zoom * dt;
  glm::dvec2 toward = glm::dvec2(0.5 * view.width, 0.5 * view.height) + view.shift;
  if (zoom_left_ != 0.0) {
    const double part = std::abs(zoom_left_) < 1e-3 ? zoom_left_ : zoom_left_ * (1.0 - std::exp(-zoom_ease * dt));
    zoom_left_ -= part;
    nearer += part;
    toward = zoom_toward_;
  }
  if (nearer != 0.0) zoom_now(scene, view, std::exp(nearer), toward);
  terrella::look(scene, push.turn * key_turn * dt, push.tilt * key_turn * dt);
  levels_ = levels_ || pushes(push);
  if (levels_) level_roll(scene, levelling, dt);
  levels_ = levels_ && scene.camera.roll != 0.0;
}

bool Orbit::moving() const { return velocity_ != glm::dvec2(0.0) || zoom_left_ != 0.0 || levels_; }

void Orbit::stop() {
  velocity_ = last_drag_ = {0.0, 0.0};
  zoom_left_ = 0.0;
  levels_ = false;
}

}  // namespace terrella
