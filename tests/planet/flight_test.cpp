#include "planet/flight.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "laws/random_places.hpp"
#include "planet/pose.hpp"
#include "scene/parameters.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

Camera camera(double latitude, double longitude, double altitude, double heading = 0.0) {
  Camera made;
  made.latitude = latitude;
  made.longitude = longitude;
  made.altitude = altitude;
  made.heading = heading;
  return made;
}

Scene bare(double radius = 1.0) {
  Scene scene = scaled(Scene{}, radius);
  scene.terrain.model = scene.water.model = 0;
  return scene;
}

Camera any_camera(test::Places& places, double radius) {
  Camera made = camera(places.between(-90.0, 90.0), places.between(-180.0, 180.0),
                       radius * std::pow(10.0, places.between(-4.0, 4.0)), places.between(-360.0, 360.0));
  made.pitch = places.between(-90.0, 90.0);
  made.fov = places.between(1.0, 170.0);
  made.roll = places.between(-180.0, 180.0);
  return made;
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

double ground_between(const Camera& a, const Camera& b) {
  return angle_between(facing_of(a).place, facing_of(b).place);
}

// How far apart what two cameras see is, as angles: of the place by the height, of the axes, of height and field.
double apart(const Camera& a, const Camera& b, double radius) {
  Scene scene = bare(radius);
  const auto pose = [&](const Camera& of) {
    scene.camera = of;
    return pose_of(scene, {});
  };
  const Pose p = pose(a), q = pose(b);
  return glm::distance(p.eye, q.eye) / std::min(p.clearance, q.clearance) + angle_between(p.forward, q.forward) +
         angle_between(p.up, q.up) + std::abs(p.tan_half_fov / q.tan_half_fov - 1.0);
}

bool is_allowed(const Camera& of) {
  Scene scene, copy;
  scene.camera = of;
  for (const Parameter& parameter : parameters()) {
    if (parameter.group == "camera" && assign(copy, parameter, parameter.get(scene))) return false;
  }
  return true;
}

// Of a flight, often to the antipode.
std::pair<Camera, Camera> any_ends(test::Places& places, bool antipodes) {
  const Camera from = any_camera(places, 1.0);
  Camera to = any_camera(places, 1.0);
  if (antipodes) to.latitude = -from.latitude, to.longitude = std::remainder(from.longitude + 180.0, 360.0);
  return {from, to};
}

TEST(Flight, BeginsAndEndsExactlyAtItsViews) {
  test::Places places(1U);
  for (const double radius : {1.0, 6.371e6}) {
    const Scene scene = scaled(Scene{}, radius);
    for (int i = 0; i < 50; ++i) {
      Camera from = any_camera(places, radius), to = any_camera(places, radius);
      from.altitude += radius;  // not under a mountain
      to.altitude += radius;
      const Flight flight(scene, from, to);
      EXPECT_EQ(flight.at(0.0), from);
      EXPECT_EQ(flight.at(1.0), to);
      // And comes there without a jump.
      EXPECT_LT(apart(flight.at(1e-9), from, radius), 1e-6);
      EXPECT_LT(apart(flight.at(1.0 - 1e-9), to, radius), 1e-6);
    }
  }
}

TEST(Flight, EndsOverGroundAndSea) {
  const Scene scene;
  const Flight flight(scene, camera(10.0, 20.0, 0.0), camera(-50.0, 70.0, 0.0));
  EXPECT_NEAR(1.0 + flight.at(0.0).altitude, surface_radius(scene, direction_of(10.0, 20.0)) + least_clearance(scene),
              1e-12);
  EXPECT_NEAR(1.0 + flight.at(1.0).altitude, surface_radius(scene, direction_of(-50.0, 70.0)) + least_clearance(scene),
              1e-12);
}

TEST(Flight, IsFiniteAndAllowedFromAnywhereToAnywhere) {
  test::Places places(2U);
  const double ends[] = {-90.0, 0.0, 90.0};
  for (const double radius : {1.0, 1e8}) {
    Scene scene = scaled(Scene{}, radius);
    scene.terrain.octaves = 4;
    for (int i = 0; i < 300; ++i) {
      Camera from = any_camera(places, radius), to = any_camera(places, radius);
      if (i % 3 == 0) from.latitude = ends[i % 9 / 3];
      if (i % 4 == 0) to = camera(-from.latitude, std::remainder(from.longitude + 180.0, 360.0), to.altitude);
      if (i % 5 == 0) to.latitude = from.latitude, to.longitude = from.longitude;
      if (i % 7 == 0) to.altitude = from.altitude;
      if (i % 11 == 0) to = from;
      if (i % 13 == 0) from.altitude = 1e12;
      if (i % 17 == 0) to.altitude = 0.0;
      const Flight flight(scene, from, to);
      ASSERT_TRUE(std::isfinite(flight.length()));
      for (const double part : {0.0, 1e-12, 0.2, 0.5, 0.8, 1.0 - 1e-12, 1.0}) {
        ASSERT_TRUE(is_allowed(flight.at(part))) << i << ' ' << part;
      }
      const Step before = flight.from_start(-0.25), after = flight.from_end(1.25);
      ASSERT_TRUE(std::isfinite(before.way.x + before.way.y + before.clearance + before.ground));
      ASSERT_TRUE(std::isfinite(after.way.x + after.way.y + after.clearance + after.ground));
    }
  }
}

TEST(Flight, StraightDownFallsByTheSameFactorEachFrame) {
  constexpr int frames = 60;
  const Flight flight(bare(), camera(14.0, 5.0, 1e7), camera(14.0, 5.0, 2.0));
  for (int i = 1; i <= frames; ++i) {
    const Camera a = flight.at((i - 1.0) / frames), b = flight.at(static_cast<double>(i) / frames);
    EXPECT_NEAR(b.altitude / a.altitude, std::pow(2e-7, 1.0 / frames), 1e-9);
    EXPECT_LT(ground_between(a, b), 1e-14);
  }
}

// In no frame does the place move by more of the height, or the height by a larger factor, than a glide allows: the
// mean.
TEST(Flight, IsSteady) {
  test::Places places(3U);
  constexpr int frames = 100;
  for (int i = 0; i < 100; ++i) {
    const Camera from = any_camera(places, 1.0), to = any_camera(places, 1.0);
    const Flight flight(bare(), from, to);
    const double glide = Glide(ground_between(from, to), from.altitude, to.altitude).length() / frames;
    for (int frame = 1; frame <= frames; ++frame) {
      const Camera a = flight.at((frame - 1.0) / frames), b = flight.at(static_cast<double>(frame) / frames);
      EXPECT_LE(ground_between(a, b) / std::max(a.altitude, b.altitude), 1.001 * glide / Glide::curvature + 1e-12);
      EXPECT_LE(std::abs(std::log(b.altitude / a.altitude)), 1.001 * glide * Glide::curvature + 1e-12);
    }
  }
}

TEST(Flight, IsContinuous) {
  test::Places places(4U);
  const Scene scene;
  for (int i = 0; i < 60; ++i) {
    const auto [from, to] = any_ends(places, i % 3 == 0);
    const Flight flight(scene, from, to);
    for (int n = 0; n < 40; ++n) {
      const double part = n == 0 ? 0.5 : places.between(1e-6, 1.0 - 1e-6);
      EXPECT_LT(apart(flight.at(part - 1e-8), flight.at(part + 1e-8), 1.0), 1e-4) << i << ' ' << part;
    }
  }
}

TEST(Flight, IsTheSameThereAndBack) {
  test::Places places(5U);
  const Scene scene;
  for (int i = 0; i < 60; ++i) {
    const auto [from, to] = any_ends(places, i % 3 == 0);
    const Flight there(scene, from, to), back(scene, to, from);
    EXPECT_NEAR(there.length(), back.length(), 1e-9);
    for (int n = 0; n <= 10; ++n) EXPECT_LT(apart(there.at(0.1 * n), back.at(1.0 - 0.1 * n), 1.0), 1e-6);
  }
}

TEST(Flight, LeadsAlongAGreatCircle) {
  test::Places places(6U);
  for (int i = 0; i < 100; ++i) {
    const Camera from = any_camera(places, 1.0), to = any_camera(places, 1.0);
    const Flight flight(bare(), from, to);
    const double whole = ground_between(from, to);
    for (int n = 1; n < 10; ++n) {
      const Camera at = flight.at(0.1 * n);
      EXPECT_NEAR(ground_between(from, at) + ground_between(at, to), whole, 1e-7);
    }
  }
}

TEST(Flight, CrossesTheDateLineAndThePole) {
  const Flight east(bare(), camera(10.0, 170.0, 0.1), camera(10.0, -170.0, 0.1));
  for (int n = 0; n <= 20; ++n) EXPECT_GE(std::abs(east.at(0.05 * n).longitude), 170.0 - 1e-9);

  // What faces ahead does so all the way, though its heading turns to the opposite over the pole.
  const Flight over(bare(), camera(80.0, 30.0, 0.1, 0.0), camera(80.0, -150.0, 0.1, 180.0));
  EXPECT_NEAR(over.at(0.5).latitude, 90.0, 1e-6);
  const glm::dvec3 axis = glm::cross(facing_of(over.from()).place, facing_of(over.from()).ahead);
  for (int n = 0; n <= 20; ++n) {
    EXPECT_LT(std::abs(glm::dot(facing_of(over.at(0.05 * n)).ahead, axis)), 1e-9);
    EXPECT_GE(over.at(0.05 * n).latitude, 80.0 - 1e-9);
  }
}

TEST(Flight, LeadsFromAntipodeToAntipodeOverThePole) {
  const Flight flight(bare(), camera(0.0, 40.0, 0.01), camera(0.0, -140.0, 0.01));
  EXPECT_NEAR(std::abs(flight.at(0.5).latitude), 90.0, 1e-5);
  const Flight poles(bare(), camera(90.0, 0.0, 0.01), camera(-90.0, 0.0, 0.01));
  EXPECT_NEAR(poles.at(0.5).latitude, 0.0, 1e-5);
  for (const Flight* one : {&flight, &poles}) {
    for (int n = 0; n <= 10; ++n) {
      const Camera at = one->at(0.1 * n);
      EXPECT_NEAR(ground_between(one->from(), at) + ground_between(at, one->to()), std::numbers::pi, 1e-7);
    }
  }
}

TEST(Flight, RisesWhereItIsFarAndOnlyThere) {
  const auto highest = [](double degrees) {
    const Flight flight(bare(), camera(0.0, 0.0, 1e-3), camera(0.0, degrees, 1e-3));
    double altitude = 0.0;
    for (int n = 0; n <= 100; ++n) altitude = std::max(altitude, flight.at(0.01 * n).altitude);
    return altitude;
  };
  EXPECT_GT(highest(90.0), 1.0);
  EXPECT_LT(highest(90.0), 2.0);
  EXPECT_LT(highest(0.01), 1.1e-3);
}

TEST(Flight, TurnsTheShortWayAndGently) {
  Camera from = camera(30.0, 30.0, 1.0, 350.0), to = camera(30.0, 30.0, 1.0, 20.0);
  to.pitch = -30.0;
  to.fov = 20.0;
  const Flight flight(bare(), from, to);
  double last = -10.0;
  for (int n = 1; n < 100; ++n) {
    const double heading = flight.at(0.01 * n).heading;
    EXPECT_GT(heading, last);
    EXPECT_LT(heading - last, 1.5 * 0.01 * 30.0 * 1.001);
    last = heading;
  }
  EXPECT_NEAR(flight.at(0.5).heading, 5.0, 1e-9);
  EXPECT_NEAR(flight.at(0.5).pitch, -60.0, 1e-9);
  EXPECT_NEAR(flight.at(0.01).heading, -10.0, 0.01);
  EXPECT_NEAR(flight.at(0.99).heading, 20.0, 0.01);
  // At the pole the longitude turns as well as the heading does.
  const Flight pole(bare(), camera(90.0, 0.0, 1.0, 0.0), camera(90.0, 100.0, 1.0, 100.0));
  EXPECT_NEAR(pole.length(), 0.0, 1e-9);
}

// From high up it looks down, so that as much of the picture shows the planet as at the ends.
TEST(Flight, KeepsThePlanetInThePicture) {
  const auto above_horizon = [](const Camera& of) {
    return (of.pitch + 90.0) / glm::degrees(std::asin(1.0 / (1.0 + of.altitude)));
  };
  Camera from = camera(10.0, 0.0, 0.03), to = camera(-40.0, 120.0, 0.03);
  from.pitch = to.pitch = -12.0;
  const Flight flight(bare(), from, to);
  EXPECT_GT(flight.at(0.5).altitude, 1.0);
  for (int n = 0; n <= 50; ++n) EXPECT_NEAR(above_horizon(flight.at(0.02 * n)), above_horizon(from), 1e-9);
  // Straight down nothing but the views asks for a tilt.
  from.latitude = to.latitude, from.longitude = to.longitude, from.altitude = 50.0;
  EXPECT_NEAR(Flight(bare(), from, to).at(0.3).pitch, -12.0, 1e-9);
}

TEST(Flight, ThatChangesNothingHasNoLength) {
  test::Places places(7U);
  for (int i = 0; i < 100; ++i) {
    const Camera here = any_camera(places, 1.0);
    const Flight flight(Scene{}, here, here);
    EXPECT_EQ(flight.length(), 0.0);
    EXPECT_LT(apart(flight.at(0.3), flight.from(), 1.0), 1e-7);
  }
}

// Over a place and another, so far away along a meridian (rad), both so high over the ground (radii).
Flight low_flight(const Scene& scene, test::Places& places, double far, double clearance) {
  const double latitude = places.between(-80.0, 80.0), longitude = places.between(-180.0, 180.0);
  const auto end = [&](double at) {
    const double surface = surface_radius(scene, direction_of(at, longitude));
    return camera(at, longitude, (surface + clearance - 1.0) * scene.planet.radius);
  };
  return {scene, end(latitude), end(latitude + (latitude > 0.0 ? -1.0 : 1.0) * glm::degrees(far))};
}

// Straight from end to end, hills would take all of the clearance from some of these.
TEST(Flight, KeepsClearOfHills) {
  Scene scene = find_preset("alps")->scene;
  for (const auto& [clearance, far] : {std::pair(0.002, 0.04), std::pair(0.01, 0.04)}) {
    test::Places places(3U);
    for (int i = 0; i < 40; ++i) {
      const Flight flight = low_flight(scene, places, far, clearance);
      for (int n = 0; n <= 40; ++n) {
        scene.camera = flight.at(n / 40.0);
        EXPECT_GT(pose_of(scene, {}).clearance, 0.2 * flight.from_start(n / 40.0).clearance);
      }
    }
  }
}

// How much a list of heights trembles from frame to frame.
double shaken(const std::vector<double>& heights) {
  double most = 0.0;
  for (std::size_t i = 2; i < heights.size(); ++i) {
    most = std::max(most, std::abs(heights[i - 2] - 2.0 * heights[i - 1] + heights[i]));
  }
  return most;
}

TEST(Flight, DoesNotTrembleAsTheGroundDoes) {
  Scene scene = find_preset("alps")->scene;
  test::Places places(8U);
  double camera_shaken = 0.0, ground_shaken = 0.0;
  for (int i = 0; i < 10; ++i) {
    const Flight flight = low_flight(scene, places, 0.02, 0.02);
    std::vector<double> heights, grounds;
    for (int n = 0; n <= 60; ++n) {
      scene.camera = flight.at(n / 60.0);
      const Pose pose = pose_of(scene, {});
      heights.push_back(glm::length(pose.eye));
      grounds.push_back(heights.back() - pose.clearance);
    }
    camera_shaken = std::max(camera_shaken, shaken(heights));
    ground_shaken = std::max(ground_shaken, shaken(grounds));
  }
  EXPECT_LT(camera_shaken, 0.3 * ground_shaken);
}

}  // namespace
}  // namespace terrella
