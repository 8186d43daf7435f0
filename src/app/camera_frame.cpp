#include "app/camera_frame.hpp"

#include <algorithm>
#include <cmath>

#include <glm/trigonometric.hpp>

namespace terrella {
namespace {

constexpr double fastest_levelling = 600.0;  // degrees a second: upside down, a planet would else be thrown around
constexpr double level_enough = 0.05;        // degrees

}  // namespace

double distance_of(const Scene& scene) { return 1.0 + scene.camera.altitude / scene.planet.radius; }

void set_distance(Scene& scene, double distance) { scene.camera.altitude = (distance - 1.0) * scene.planet.radius; }

void keep_raised(Scene& scene, const View& view) {
  if (pose_of(scene, view).raised)
    set_distance(scene, surface_radius(scene, facing_of(scene.camera).place) + least_clearance(scene));
}

double wrapped(double degrees) { return std::remainder(degrees, 360.0); }

void move_over(Scene& scene, double right_angle, double ahead_angle) {
  if (right_angle == 0.0 && ahead_angle == 0.0) return;
  set_facing(scene.camera, carried(facing_of(scene.camera), {right_angle, ahead_angle}));
}

glm::dvec2 levelled(const Scene& scene, glm::dvec2 movement) {
  const double roll = glm::radians(scene.camera.roll), c = std::cos(roll), s = std::sin(roll);
  return {movement.x * c - movement.y * s, movement.x * s + movement.y * c};
}

glm::dvec2 turn_of(const Scene& scene, const View& view, glm::dvec2 pixels) {
  const double degrees = scene.camera.fov / std::min(view.width, view.height);
  return glm::dvec2(degrees, -degrees) * levelled(scene, pixels);
}

void look(Scene& scene, double right, double up) {
  scene.camera.heading = wrapped(scene.camera.heading + right);
  scene.camera.pitch = std::clamp(scene.camera.pitch + up, -90.0, 90.0);
}

void look(Scene& scene, const View& view, glm::dvec2 pixels) {
  const glm::dvec2 turn = turn_of(scene, view, pixels);
  look(scene, turn.x, turn.y);
}

void level_roll(Scene& scene, double within, double dt) {
  double& roll = scene.camera.roll;
  const double most = fastest_levelling * dt;
  roll -= std::clamp(roll * (1.0 - std::exp(-4.0 * dt / within)), -most, most);
  if (std::abs(roll) < level_enough) roll = 0.0;
}

double natural_pitch(double clearance) {
  const double nearness = std::clamp(std::log(0.7 / clearance) / std::log(0.7 / 0.004), 0.0, 1.0);
  return -90.0 + 74.0 * nearness * nearness * (3.0 - 2.0 * nearness);
}

}  // namespace terrella
