#include "planet/facing.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "planet/pose.hpp"

namespace terrella {
namespace {

// From the longitude itself: there is an east at the poles, too.
glm::dvec3 east_at(double longitude) {
  const double lon = glm::radians(longitude);
  return {-std::sin(lon), std::cos(lon), 0.0};
}

}  // namespace

Facing facing_of(const Camera& camera) {
  const glm::dvec3 place = direction_of(camera.latitude, camera.longitude), east = east_at(camera.longitude);
  const double heading = glm::radians(camera.heading);
  return {place, std::cos(heading) * glm::cross(place, east) + std::sin(heading) * east};
}

void set_facing(Camera& camera, const Facing& facing) {
  const glm::dvec3& place = facing.place;
  camera.latitude = glm::degrees(std::atan2(place.z, std::hypot(place.x, place.y)));
  camera.longitude = glm::degrees(std::atan2(place.y, place.x));
  const glm::dvec3 east = east_at(camera.longitude), north = glm::cross(place, east);
  camera.heading = glm::degrees(std::atan2(glm::dot(facing.ahead, east), glm::dot(facing.ahead, north)));
}

glm::dvec3 right_of(const Facing& facing) { return glm::cross(facing.ahead, facing.place); }

Facing carried(const Facing& facing, const glm::dvec2& way) {
  const double angle = std::hypot(way.x, way.y);
  if (angle == 0.0) return facing;
  const glm::dvec3 along = (way.x * right_of(facing) + way.y * facing.ahead) / angle;
  const glm::dvec3 along_there = std::cos(angle) * along - std::sin(angle) * facing.place;
  return {std::cos(angle) * facing.place + std::sin(angle) * along,
          facing.ahead + glm::dot(facing.ahead, along) * (along_there - along)};
}

Facing turned(const Facing& facing, double angle) {
  return {facing.place, std::cos(angle) * facing.ahead + std::sin(angle) * right_of(facing)};
}

}  // namespace terrella
