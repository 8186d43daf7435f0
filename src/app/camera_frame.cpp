#include "app/camera_frame.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace terrella {
namespace {

constexpr double fastest_levelling = 600.0;  // degrees a second: upside down, a planet would else be thrown around
constexpr double level_enough = 0.05;        // degrees

struct Compass {
  glm::dvec3 east, north;
};

// From the longitude itself: defined at the poles, too.
Compass compass_at(const glm::dvec3& place, double longitude) {
  const double lon = glm::radians(longitude);
  const glm::dvec3 east(-std::sin(lon), std::cos(lon), 0.0);
  return {east, glm::cross(place, east)};
}

}  // namespace

CameraFrame frame_of(const Scene& scene) {
  const auto& camera = scene.camera;
  const glm::dvec3 place = direction_of(camera.latitude, camera.longitude);
  const auto [east, north] = compass_at(place, camera.longitude);
  const double heading = glm::radians(camera.heading);
  return {place, std::cos(heading) * east - std::sin(heading) * north,
          std::cos(heading) * north + std::sin(heading) * east};
}

double distance_of(const Scene& scene) { return 1.0 + scene.camera.altitude / scene.planet.radius; }

void set_distance(Scene& scene, double distance) { scene.camera.altitude = (distance - 1.0) * scene.planet.radius; }

double lowest_clearance(const Scene& /*scene*/) { return least_clearance; }

double wrapped(double degrees) { return std::remainder(degrees, 360.0); }

void move_over(Scene& scene, double right_angle, double ahead_angle) {
  auto& camera = scene.camera;
  const auto [place, right, ahead] = frame_of(scene);
  const double angle = std::hypot(right_angle, ahead_angle);
  if (angle == 0.0) return;
  const glm::dvec3 along = (right_angle * right + ahead_angle * ahead) / angle;
  const glm::dvec3 moved = std::cos(angle) * place + std::sin(angle) * along;
  const glm::dvec3 along_moved = std::cos(angle) * along - std::sin(angle) * place;
  const glm::dvec3 ahead_moved = ahead + glm::dot(ahead, along) * (along_moved - along);
  // An arc sine would lose half of the digits near the poles.
  camera.latitude = glm::degrees(std::atan2(moved.z, std::hypot(moved.x, moved.y)));
  camera.longitude = glm::degrees(std::atan2(moved.y, moved.x));
  const auto [east, north] = compass_at(moved, camera.longitude);
  camera.heading = wrapped(glm::degrees(std::atan2(glm::dot(ahead_moved, east), glm::dot(ahead_moved, north))));
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
