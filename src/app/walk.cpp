#include "app/walk.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "app/camera_frame.hpp"
#include "app/human.hpp"

namespace terrella {
namespace {

// Metres and seconds of people.
constexpr double gravity = 9.81;
constexpr double walking = 1.4, running = 5.0;  // along the ground
constexpr double jumping = 3.0;                 // upwards, which leads half a metre high
constexpr double terminal = 55.0;               // as fast as air lets people fall
constexpr double reach = 0.25;                  // of the feet, over which the slope of the ground is told
constexpr double knee = 0.5;  // lower over the ground, its slope hinders: nobody jumps up what is too steep
// From orbit, gravity alone would take half an hour. Higher than this, a fall also sheds a part of its height in each
// second, so that it takes at most a quarter of a minute from wherever hands come to.
constexpr double high = 30.0;
constexpr double shed = 2.0;         // 1/s
constexpr double begin_haste = 0.3;  // s
// Rise per length. Between the first two what leads uphill is lost: the ground is not climbed, one slides along it.
constexpr double hard = 0.85, too_steep = 1.0;
constexpr double edge = 1.2;       // down which nobody walks any more, but falls
constexpr double ease = 10.0;      // 1/s, of coming into motion and to rest
constexpr double stand_up = 0.1;   // s, for most of the way to full height
constexpr double levelling = 0.3;  // s
constexpr double rest = 1e-3;      // below this part of walking it stands
constexpr double touch = 1e-7;     // of the eyes' height: nearer to the ground feet stand on it
constexpr double key_turn = 50.0;  // degrees a second

double ground_at(const Scene& scene) { return surface_radius(scene, facing_of(scene.camera).place); }

double feet_of(const Scene& scene) { return distance_of(scene) - eye_height(scene); }

// Rise of the ground per length to the right and ahead.
glm::dvec2 slope_at(const Scene& scene) {
  const Facing facing = facing_of(scene.camera);
  const double angle = reach * human_metre(scene);
  const auto along = [&](const glm::dvec3& side) {
    const double there = surface_radius(scene, glm::normalize(facing.place + angle * side));
    const double back = surface_radius(scene, glm::normalize(facing.place - angle * side));
    return (there - back) / (angle * (there + back));
  };
  return {along(right_of(facing)), along(facing.ahead)};
}

// What is left of a way over the ground where that slopes. Lengths count along the slope.
glm::dvec2 passable(glm::dvec2 way, glm::dvec2 slope) {
  const double steepness = glm::length(slope), climbed = glm::dot(way, slope);
  if (steepness > hard && climbed > 0.0) {
    const double share = std::min((steepness - hard) / (too_steep - hard), 1.0);
    way -= share * climbed / (steepness * steepness) * slope;
  }
  const double length = glm::length(way);
  return length > 0.0 ? way / std::hypot(1.0, glm::dot(way, slope) / length) : way;
}

bool leads_over_edge(glm::dvec2 way, glm::dvec2 slope) { return glm::dot(way, slope) < -edge * glm::length(way); }

}  // namespace

bool stands_on_ground(const Scene& scene) {
  return std::abs(feet_of(scene) - ground_at(scene)) < 1e-3 * eye_height(scene);
}

// The way within a step.
glm::dvec2 Walk::gather_way(const Push& push, double metre, double dt) {
  const double speed = metre * (push.fast ? running : walking);
  const glm::dvec2 wish = speed * held_to_one(glm::dvec2(push.right, push.ahead));
  const glm::dvec2 way = eased_way(velocity_, wish, ease, dt);
  if (wish == glm::dvec2(0.0) && glm::length(velocity_) < rest * metre * walking) velocity_ = glm::dvec2(0.0);
  return way;
}

// Returns the height over the ground that is left of one after a step.
double Walk::fall(Scene& scene, double height, double metre, double dt) {
  const double before = rising_, eye = eye_height(scene);
  rising_ = std::max(before - gravity * metre * dt, -terminal * metre);
  double left = height + 0.5 * (before + rising_) * dt;
  haste_ += (1.0 - haste_) * -std::expm1(-dt / begin_haste);
  if (left > high * metre) {
    from_high_ = true;
    left = high * metre + (left - high * metre) * std::exp(-shed * haste_ * dt);
  }
  left = std::max(left, 0.0);
  // As on coming nearer in orbit.
  if (from_high_) look(scene, 0.0, natural_pitch(left + eye) - natural_pitch(std::max(height, 0.0) + eye));
  if (left == 0.0) land();
  return left;
}

void Walk::land() {
  rising_ = haste_ = 0.0;
  from_high_ = false;
}

void Walk::step(Scene& scene, const Push& push, double dt) {
  const double metre = human_metre(scene), eye = eye_height(scene);
  const double height = feet_of(scene) - ground_at(scene);
  const bool on_ground = rising_ <= 0.0 && height <= touch * eye;
  look(scene, push.turn * key_turn * dt, push.tilt * key_turn * dt);
  level_roll(scene, levelling, dt);

  glm::dvec2 way = gather_way(push, metre, dt);
  const glm::dvec2 slope = way == glm::dvec2(0.0) ? way : slope_at(scene);
  if (on_ground && push.jump) rising_ = jumping * metre;
  if (height < knee * metre) way = passable(way, slope);
  const double feet = feet_of(scene);
  move_over(scene, way.x / feet, way.y / feet);

  const double ground = ground_at(scene);
  const bool keeps_ground = on_ground && rising_ <= 0.0 && !leads_over_edge(way, slope);
  const double sunk = std::max(0.0, -height) * std::exp(-4.0 * dt / stand_up);
  const double left = keeps_ground ? -sunk : fall(scene, feet - ground, metre, dt);
  if (keeps_ground) land();
  // What is only rounded otherwise is left alone: a planet at rest would be drawn again and again.
  const bool moves = std::abs(ground + left - feet) > touch * eye;
  if (moves) set_distance(scene, ground + left + eye);
  stands_ = keeps_ground && !moves && velocity_ == glm::dvec2(0.0) && scene.camera.roll == 0.0;
}

}  // namespace terrella
