#include "app/fly_to.hpp"

#include <algorithm>

#include <glm/common.hpp>

#include "app/camera_frame.hpp"

namespace terrella {
namespace {

constexpr double shortest = 1.0, longest = 8.0;  // s

}  // namespace

Camera view_of_place(const Scene& scene, const Destination& there, std::optional<double> clearance) {
  const double radius = scene.planet.radius, here = pose_of(scene, {}).clearance;
  Camera camera = scene.camera;
  camera.latitude = there.latitude;
  camera.longitude = there.longitude;
  camera.roll = 0.0;
  const double surface = surface_radius(scene, direction_of(there.latitude, there.longitude));
  double wanted = clearance.value_or(here);
  if (there.altitude) wanted = 1.0 + *there.altitude / radius - surface;
  wanted = std::max(wanted, least_clearance(scene));
  camera.altitude = std::max(0.0, (surface + wanted - 1.0) * radius);
  camera.pitch = std::clamp(camera.pitch + natural_pitch(wanted) - natural_pitch(here), -90.0, 90.0);
  return camera;
}

void FlyTo::start(const Scene& scene, const Camera& to) {
  flight_.emplace(scene, scene.camera, to);
  left_ = scene;
  passed_ = 0.0;
  seconds_ = std::clamp(flight_->length(), shortest, longest);
}

void FlyTo::tick(Scene& scene, const View& view, double dt) {
  if (!(scene == left_)) return stop();
  passed_ += dt;
  const double part = std::min(passed_ / seconds_, 1.0);
  scene.camera = flight_->at(flight_->moves() ? glm::smoothstep(0.0, 1.0, part) : part);
  keep_raised(scene, view);
  left_ = scene;
  if (part == 1.0) stop();
}

}  // namespace terrella
