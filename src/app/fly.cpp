#include "app/fly.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "app/camera_frame.hpp"
#include "app/human.hpp"

namespace terrella {
namespace {

constexpr double speed = 1.0;      // clearances a second
constexpr double slowest = 1.5;    // m/s of people: as fast as they walk, at the height of their eyes and below
constexpr double fast = 4.0;       // with Shift
constexpr double widest = 16.0;    // factor that the pace can be changed by, either way
constexpr double ease = 5.0;       // 1/s, of coming into motion and to rest
constexpr double rest = 1e-3;      // below this part of full speed it stands
constexpr double key_turn = 50.0;  // degrees a second
constexpr double key_pace = 1.3;   // logarithm of the factor, a second

// Past straight up or down, what was behind is ahead, and the camera is upside down.
void turn(Scene& scene, glm::dvec2 right_and_up) {
  auto& camera = scene.camera;
  camera.heading = wrapped(camera.heading + right_and_up.x);
  camera.pitch += right_and_up.y;
  if (std::abs(camera.pitch) <= 90.0) return;
  camera.pitch = std::clamp(std::copysign(180.0, camera.pitch) - camera.pitch, -90.0, 90.0);
  camera.heading = wrapped(camera.heading + 180.0);
  camera.roll = wrapped(camera.roll + 180.0);
}

// To the right, ahead along the horizon and up, of a motion as seen by the camera.
glm::dvec3 over_planet(const Scene& scene, const glm::dvec3& motion) {
  const double pitch = glm::radians(scene.camera.pitch), roll = glm::radians(scene.camera.roll);
  const glm::dvec3 forward(0.0, std::cos(pitch), std::sin(pitch));
  const glm::dvec3 level_up(0.0, -std::sin(pitch), std::cos(pitch));
  const glm::dvec3 right = std::cos(roll) * glm::dvec3(1.0, 0.0, 0.0) - std::sin(roll) * level_up;
  return motion.x * right + motion.y * forward + glm::dvec3(0.0, 0.0, motion.z);
}

}  // namespace

void Fly::look(Scene& scene, const View& view, glm::dvec2 pixels) { turn(scene, turn_of(scene, view, pixels)); }

void Fly::hasten(double factor) { pace_ = std::clamp(pace_ * factor, 1.0 / widest, widest); }

void Fly::step(Scene& scene, const Push& push, double dt) {
  hasten(std::exp(key_pace * push.nearer * dt));
  scene.camera.roll = wrapped(scene.camera.roll + key_turn * push.turn * dt);
  if (push.tilt != 0.0) turn(scene, glm::dvec2(1.0, -1.0) * levelled(scene, {0.0, -key_turn * push.tilt * dt}));

  const glm::dvec3 wish = held_to_one(glm::dvec3(push.right, push.ahead, push.up));
  const glm::dvec3 way = over_planet(scene, eased_way(motion_, wish, ease, dt));
  if (wish == glm::dvec3(0.0) && glm::length(motion_) < rest) stop();
  if (way == glm::dvec3(0.0)) return;

  const double distance = distance_of(scene);
  const double clearance =
      std::max(distance - surface_radius(scene, facing_of(scene.camera).place), least_clearance(scene));
  const double pace = pace_ * (push.fast ? fast : 1.0);
  const auto speed_at = [&](double height) { return pace * std::max(speed * height, slowest * human_metre(scene)); };
  const double halfway = std::max(0.0, clearance + 0.5 * way.z * speed_at(clearance));
  const glm::dvec3 moved = speed_at(halfway) * way;
  move_over(scene, moved.x / distance, moved.y / distance);
  const double lowest = surface_radius(scene, facing_of(scene.camera).place) + least_clearance(scene);
  const double highest = std::max(distance, 1.0 + farthest);  // who comes from farther away is not thrown nearer
  set_distance(scene, std::clamp(distance + moved.z, lowest, std::max(lowest, highest)));
}

}  // namespace terrella
