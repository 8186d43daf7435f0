#include <vector>

#include "camera_places.hpp"
#include "laws/random_places.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

using test::Held;

TEST(Fly, GoesAsFarAsTheGroundIsBelowInTheSameTimeAtEveryHeight) {
  for (const double radius : {1.0, 6.371e6, 1e8}) {
    for (double clearance = 0.002; clearance < 9e3; clearance *= 7.0) {
      Scene scene = test::bare_planet(radius);
      test::put_over_ground(scene, clearance);
      Held flight(scene, CameraMode::fly);
      flight.hold({.ahead = 1.0}, 2.0);  // at full speed
      double flown = 0.0;
      flight.hold({.ahead = 1.0}, 1.0, [&, before = facing_of(scene.camera).place]() mutable {
        const glm::dvec3 place = facing_of(scene.camera).place;
        flown += 2.0 * std::asin(0.5 * glm::distance(place, before)) * (1.0 + clearance);
        before = place;
      });
      EXPECT_NEAR(flown / clearance, 1.0, 1e-3) << clearance << " radii over a planet of " << radius << " m";
      EXPECT_NEAR(distance_of(scene) - 1.0, clearance, 1e-9 * (1.0 + clearance));  // level
    }
  }
}

TEST(Fly, ComesNearerByTheSameFactorInTheSameTime) {
  Scene scene = test::bare_planet(6.371e6);
  scene.camera.pitch = -90.0;
  test::put_over_ground(scene, 3.0);
  Held flight(scene, CameraMode::fly);
  flight.hold({.ahead = 1.0}, 1.5);
  std::vector<double> heights;
  for (int i = 0; i < 4; ++i) {
    heights.push_back(distance_of(scene) - 1.0);
    flight.hold({.ahead = 1.0}, 0.5);
  }
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(heights[i] / heights[i + 1], std::exp(0.5), 2e-3);
}

TEST(Fly, IsAsFastAsAWalkerWhereTheGroundIsNear) {
  // Where eyes are lower than the camera may come, there is no such place.
  Scene scene = test::bare_planet(1.0);
  test::put_over_ground(scene, 0.5 * human_metre(scene));
  Held flight(scene, CameraMode::fly);
  flight.hold({.ahead = 1.0}, 2.0);
  const glm::dvec3 before = test::eye_of(scene);
  flight.hold({.right = 1.0}, 2.0);
  flight.hold({.ahead = 1.0}, 2.0);
  const glm::dvec3 between = test::eye_of(scene);
  flight.hold({.ahead = 1.0}, 2.0);
  EXPECT_NEAR(test::metres_between(scene, between, test::eye_of(scene)), 3.0, 0.01);
  EXPECT_GT(test::metres_between(scene, before, between), 3.0);
}

TEST(Fly, IsTheSameInFewFramesAndInMany) {
  for (const double radius : {1.0, 6.371e6}) {
    std::vector<glm::dvec3> ends;
    std::vector<double> headings;
    for (const double frame : {1.0 / 30.0, 1.0 / 240.0}) {
      Scene scene = test::hilly_planet(radius, 0.02 * radius);
      test::put_over_ground(scene, 0.3);
      Held flight(scene, CameraMode::fly);
      flight.frame = frame;
      flight.hold({.ahead = 1.0, .turn = 0.3}, 1.0);
      flight.hold({.ahead = 1.0, .up = -1.0, .tilt = -0.2}, 1.0);
      flight.hold({.right = -1.0, .fast = true}, 0.5);
      flight.hold({}, 1.0);
      ends.push_back(test::eye_of(scene));
      headings.push_back(scene.camera.heading);
    }
    EXPECT_LT(glm::distance(ends[0], ends[1]), 3e-4);  // of a way of about one radius
    EXPECT_NEAR(headings[0], headings[1], 0.2);
  }
}

TEST(Fly, CarriesTheHeadingAlongOverAPole) {
  Scene scene = test::bare_planet(1.0);
  scene.camera.latitude = 89.0;
  scene.camera.longitude = 20.0;
  scene.camera.heading = 0.05;
  scene.camera.roll = 25.0;
  test::put_over_ground(scene, 0.01);
  Held flight(scene, CameraMode::fly);
  Pose before = pose_of(scene, {});
  flight.hold({.ahead = 1.0}, 5.0, [&] {
    const Pose after = pose_of(scene, {});
    ASSERT_LT(glm::distance(before.right, after.right), 0.001);
    ASSERT_LT(glm::distance(before.forward, after.forward), 0.001);
    before = after;
  });
  EXPECT_NEAR(std::abs(wrapped(scene.camera.longitude - 200.0)), 0.0, 5.0);  // on the other side
  EXPECT_NEAR(scene.camera.roll, 25.0, 1e-12);
  EXPECT_NEAR(distance_of(scene), 1.01, 1e-9);
}

TEST(Fly, NeverEntersTheGround) {
  test::Places places(3U);
  for (const Preset& preset : presets()) {
    Scene scene = preset.scene;
    test::put_over_ground(scene, 0.05);
    scene.camera.pitch = -30.0;
    Held flight(scene, CameraMode::fly);
    for (int i = 0; i < 8; ++i) {
      const Push push{.right = places.between(-1.0, 1.0),
                      .ahead = 1.0,
                      .up = places.between(-1.0, 0.2),
                      .tilt = places.between(-0.3, 0.3),
                      .fast = i % 2 == 0};
      flight.hold(push, 0.5, [&] {
        const Pose pose = pose_of(scene, {});
        ASSERT_GE(pose.clearance, (1.0 - 1e-9) * least_clearance(scene)) << preset.name;
        ASSERT_LT(std::abs(glm::length(pose.eye) - distance_of(scene)), 1e-12) << preset.name;  // it was kept
      });
    }
  }
}

TEST(Fly, LooksOverTheTopWithoutAJump) {
  Scene scene = test::bare_planet(1.0);
  scene.camera.roll = 0.0;
  Pose before = pose_of(scene, {});
  double turned = 0.0;
  for (int i = 0; i < 400; ++i) {
    Fly::look(scene, {}, {0.0, -20.0});
    const Pose after = pose_of(scene, {});
    const double angle = std::acos(std::min(1.0, glm::dot(before.forward, after.forward)));
    ASSERT_NEAR(angle, glm::radians(20.0 * 45.0 / 720.0), 1e-6) << scene.camera.pitch;
    ASSERT_GT(glm::dot(before.right, after.right), 1.0 - 1e-9);
    turned += angle;
    before = after;
    test::expect_finite(scene);
  }
  EXPECT_GT(turned, 6.3);  // all around
}

TEST(Fly, ThePictureFollowsTheHandHoweverFarItRolls) {
  for (const double roll : {-180.0, -120.0, -90.0, -30.0, 0.0, 45.0, 90.0, 170.0}) {
    Scene scene = test::bare_planet(1.0);
    scene.camera.roll = roll;
    const Pose before = pose_of(scene, {});
    Fly::look(scene, {}, {8.0, 0.0});
    const Pose right = pose_of(scene, {});
    EXPECT_NEAR(glm::dot(right.forward, before.right), glm::radians(0.5), 1e-4) << roll;
    EXPECT_NEAR(glm::dot(right.forward, before.up), 0.0, 1e-4) << roll;
    Fly::look(scene, {}, {-8.0, -8.0});
    const Pose up = pose_of(scene, {});
    EXPECT_NEAR(glm::dot(up.forward, before.right), 0.0, 1e-4) << roll;
    EXPECT_NEAR(glm::dot(up.forward, before.up), glm::radians(0.5), 1e-4) << roll;
  }
}

TEST(Fly, TheWheelChangesTheSpeedWithinBounds) {
  const auto flown = [](const std::vector<double>& notches) {
    Scene scene = test::bare_planet(1.0);
    test::put_over_ground(scene, 0.01);
    Held flight(scene, CameraMode::fly);
    for (const double factor : notches) flight.control.zoom(factor, {});
    const glm::dvec3 before = test::eye_of(scene);
    flight.hold({.ahead = 1.0}, 0.5);
    return glm::distance(before, test::eye_of(scene));
  };
  const double usual = flown({});
  EXPECT_NEAR(flown({1.5, 2.0}) / usual, 3.0, 0.01);
  EXPECT_NEAR(flown({0.5}) / usual, 0.5, 0.01);
  EXPECT_NEAR(flown(std::vector<double>(50, 1.5)) / usual, 16.0, 0.1);
  EXPECT_NEAR(flown(std::vector<double>(50, 0.5)) * 16.0 / usual, 1.0, 0.01);
}

TEST(Fly, RunsOnForAWhileAndComesToRest) {
  Scene scene = test::bare_planet(1.0);
  Held flight(scene, CameraMode::fly);
  flight.hold({.ahead = 1.0}, 1.0);
  flight.control.push({});
  EXPECT_TRUE(flight.control.moving());
  int ticks = 0;
  while (flight.control.moving() && ticks < 1000) {
    flight.control.tick(scene, {}, flight.frame);
    ++ticks;
  }
  EXPECT_GT(ticks, 10);
  EXPECT_LT(ticks, 180);
  EXPECT_FALSE(flight.control.tick(scene, {}, flight.frame));
}

}  // namespace
}  // namespace terrella
