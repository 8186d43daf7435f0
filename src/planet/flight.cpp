#include "planet/flight.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "planet/pose.hpp"
#include "scene/parameters.hpp"

namespace terrella {
namespace {

constexpr double least_angle = 1e-12;  // rad; closer places, or antipodes, have no great circle that one could tell

double eased(double part) { return glm::smoothstep(0.0, 1.0, part); }

double magnification(double fov) { return 1.0 / std::tan(0.5 * glm::radians(fov)); }

double fov_between(double from, double to, double share) {
  if (from == to) return from;
  const double tangent = std::pow(magnification(from), share - 1.0) * std::pow(magnification(to), -share);
  return glm::degrees(2.0 * std::atan(tangent));
}

// The short way, degrees.
double roll_between(double from, double to, double share) {
  return std::remainder(from + share * std::remainder(to - from, 360.0), 360.0);
}

// Half the angle under which the planet is seen, rad.
double half_of_planet(double clearance) { return std::asin(1.0 / (1.0 + clearance)); }

// The axis of a great circle through two places, around which one gets to the other by less than half a turn. Where any
// would do, it leads over the poles; between the poles, over longitude 90 degrees. From antipode to antipode it is the
// same circle there and back.
glm::dvec3 axis_through(const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 across = glm::cross(from, to);
  if (glm::length(across) > least_angle) return glm::normalize(across);
  const glm::dvec3 over_poles = glm::cross(from, {0.0, 0.0, 1.0});
  if (glm::length(over_poles) > least_angle) return glm::normalize(over_poles);
  return glm::normalize(glm::cross(from, {0.0, 1.0, 0.0}));
}

// Of a level direction, rad to the right of ahead.
double bearing_of(const Facing& facing, const glm::dvec3& level) {
  return std::atan2(glm::dot(level, right_of(facing)), glm::dot(level, facing.ahead));
}

glm::dvec2 way_along(double bearing, double angle) { return angle * glm::dvec2(std::sin(bearing), std::cos(bearing)); }

}  // namespace

Step between(const Step& from, const Step& to, double share) {
  return {from.way + share * (to.way - from.way),   std::lerp(from.turn, to.turn, share),
          std::lerp(from.ground, to.ground, share), from.clearance * std::pow(to.clearance / from.clearance, share),
          std::lerp(from.pitch, to.pitch, share),   fov_between(from.fov, to.fov, share),
          roll_between(from.roll, to.roll, share)};
}

Flight::End Flight::end_of(const Scene& scene, const Camera& camera) {
  End end{camera, facing_of(camera), 0.0, 0.0};
  end.ground = surface_radius(scene, end.facing.place);
  const double radius = scene.planet.radius;
  end.clearance = 1.0 + camera.altitude / radius - end.ground;
  if (const double least = least_clearance(scene); end.clearance < least) {
    end.clearance = least;
    end.camera.altitude = (end.ground + least - 1.0) * radius;
  }
  return end;
}

Flight::Flight(const Scene& scene, const Camera& from, const Camera& to)
    : scene_(scene), from_(end_of(scene, from)), to_(end_of(scene, to)), glide_(0.0, 1.0, 1.0) {
  lay_great_circle();
  glide_ = Glide(angle_, from_.clearance, to_.clearance);
  from_.residual = from_.ground - smooth_ground(0.0);
  to_.residual = to_.ground - smooth_ground(1.0);
  constexpr double one_turn = 0.25 * std::numbers::pi;  // a unit
  const double pitch = glm::radians(to.pitch - from.pitch);
  const double roll = glm::radians(std::remainder(to.roll - from.roll, 360.0));
  const double turn = std::max({std::abs(turn_), std::abs(pitch), std::abs(roll)}) / one_turn;
  const double zoom = std::abs(std::log2(magnification(to.fov) / magnification(from.fov)));
  length_ = std::max({glide_.length(), turn, zoom});
}

void Flight::lay_great_circle() {
  const glm::dvec3 &from = from_.facing.place, &to = to_.facing.place;
  const glm::dvec3 axis = axis_through(from, to);
  const double sine = glm::length(glm::cross(from, to)), cosine = glm::dot(from, to);
  angle_ = sine > least_angle ? std::atan2(sine, cosine) : cosine > 0.0 ? 0.0 : std::numbers::pi;
  from_.bearing = bearing_of(from_.facing, glm::cross(axis, from));
  to_.bearing = bearing_of(to_.facing, glm::cross(axis, to));
  turn_ = std::remainder(from_.bearing - to_.bearing, 2.0 * std::numbers::pi);
}

// The mean of the ground along the way, as far before and behind as the camera is high, and weighted towards the place
// itself: what is small beside the clearance does not shake the camera.
double Flight::smooth_ground(double part) const {
  if (angle_ == 0.0) return from_.ground;
  constexpr int samples = 12;  // on each side
  constexpr double reach = Glide::curvature;
  double sum = 0.0, weights = 0.0;
  for (int i = -samples; i <= samples; ++i) {
    const double x = static_cast<double>(i) / (samples + 1);
    const double weight = (1.0 - x * x) * (1.0 - x * x);
    const double along = glide_.from_start(part + reach * x / glide_.length()).along;
    sum += weight * surface_radius(scene_, carried(from_.facing, way_along(from_.bearing, along)).place);
    weights += weight;
  }
  return sum / weights;
}

// Of the view from straight down, degrees. Where the flight rises over a straight one between its ends, the planet
// would sink out of the picture: so it tilts down as the planet gets smaller by that.
double Flight::tilt(double clearance, double part) const {
  const double straight = from_.clearance * std::pow(to_.clearance / from_.clearance, part);
  const double asked = 90.0 + std::lerp(from_.camera.pitch, to_.camera.pitch, eased(part));
  return asked * half_of_planet(clearance) / half_of_planet(straight);
}

// All but the way and the turn, which depend on the end that they are told from.
Step Flight::step(double part) const {
  const double gently = eased(part);
  Step step;
  step.ground = smooth_ground(part) + std::lerp(from_.residual, to_.residual, part);
  step.clearance = part < 0.5 ? glide_.from_start(part).height : glide_.from_end(part).height;
  step.pitch = std::clamp(tilt(step.clearance, part) - 90.0, -90.0, 90.0);
  step.fov = fov_between(from_.camera.fov, to_.camera.fov, gently);
  step.roll = roll_between(from_.camera.roll, to_.camera.roll, gently);
  return step;
}

Step Flight::from_start(double part) const {
  Step step = this->step(part);
  step.way = way_along(from_.bearing, glide_.from_start(part).along);
  step.turn = turn_ * eased(part);
  return step;
}

Step Flight::from_end(double part) const {
  Step step = this->step(part);
  step.way = way_along(to_.bearing, glide_.from_end(part).along);
  step.turn = turn_ * (eased(part) - 1.0);
  return step;
}

Camera Flight::at(double part) const {
  if (!(part > 0.0)) return from_.camera;
  if (part >= 1.0) return to_.camera;
  const double radius = scene_.planet.radius;
  return part < 0.5 ? camera_at(from_.facing, from_start(part), radius) : camera_at(to_.facing, from_end(part), radius);
}

Camera camera_at(const Facing& facing, const Step& step, double radius) {
  static const double highest = find_parameter("camera.altitude")->max;
  Camera camera;
  set_facing(camera, turned(carried(facing, step.way), step.turn));
  camera.altitude = std::clamp((step.ground + step.clearance - 1.0) * radius, 0.0, highest);
  camera.pitch = step.pitch;
  camera.fov = step.fov;
  camera.roll = step.roll;
  return camera;
}

}  // namespace terrella
