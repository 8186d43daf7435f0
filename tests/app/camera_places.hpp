// Planets to move a camera over, and what it does there.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "app/camera_control.hpp"
#include "app/camera_frame.hpp"
#include "app/human.hpp"

namespace terrella::test {

inline Scene bare_planet(double radius) {
  Scene scene;
  scene.planet.radius = radius;
  scene.terrain.model = 0;
  scene.water.model = 0;
  scene.camera.altitude = radius;
  scene.camera.pitch = 0.0;
  return scene;
}

// With hills, and a sea between them if that is asked for.
inline Scene hilly_planet(double radius, double height, double sea = 0.0) {
  Scene scene;
  scene.planet.radius = radius;
  scene.terrain.height = height;
  scene.water.level = sea;
  scene.camera.pitch = 0.0;
  return scene;
}

inline Scene earth() { return hilly_planet(6.371e6, 2e4, 1e3); }

inline double ground_under(const Scene& scene) { return surface_radius(scene, facing_of(scene.camera).place); }

inline void put_over_ground(Scene& scene, double clearance) { set_distance(scene, ground_under(scene) + clearance); }

inline void stand(Scene& scene) { put_over_ground(scene, eye_height(scene)); }

inline glm::dvec3 eye_of(const Scene& scene) { return distance_of(scene) * facing_of(scene.camera).place; }

// Metres of people between two places.
inline double metres_between(const Scene& scene, const glm::dvec3& a, const glm::dvec3& b) {
  return glm::distance(a, b) / human_metre(scene);
}

inline void expect_finite(const Scene& scene) {
  const auto& camera = scene.camera;
  for (const double value :
       {camera.altitude, camera.heading, camera.latitude, camera.longitude, camera.pitch, camera.roll}) {
    ASSERT_TRUE(std::isfinite(value));
  }
  ASSERT_LE(std::abs(camera.latitude), 90.0);
  ASSERT_LE(std::abs(camera.longitude), 180.0);
  ASSERT_LE(std::abs(camera.heading), 360.0);
  ASSERT_LE(std::abs(camera.pitch), 90.0);
  ASSERT_LE(std::abs(camera.roll), 180.0);
  ASSERT_GE(camera.altitude, 0.0);
  ASSERT_LE(camera.altitude, 1e12);
}

// A camera in one mode whose keys are held for some seconds, in frames of some length.
struct Held {
  Scene& scene;
  CameraControl control{};
  double frame = 1.0 / 60.0;

  Held(Scene& over, CameraMode mode) : scene(over) { control.set_mode(mode); }

  void hold(const Push& push, double seconds) {
    hold(push, seconds, [] {});
  }

  template <class Look>
  void hold(const Push& push, double seconds, Look look_after_each) {
    control.push(push);
    for (long i = std::lround(seconds / frame); i > 0; --i) {
      control.tick(scene, {}, frame);
      look_after_each();
      if (testing::Test::HasFatalFailure()) return;
    }
  }
};

}  // namespace terrella::test
