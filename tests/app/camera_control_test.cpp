#include "app/camera_control.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "laws/random_places.hpp"

namespace terrella {
namespace {

TEST(CameraControl, TurnsThePlanetWithTheHand) {
  Scene scene;
  CameraControl control;
  control.drag(scene, {}, {100.0, 0.0});
  EXPECT_LT(scene.camera.longitude, 0.0);  // the ground follows the hand to the right, so the camera goes left
  EXPECT_NEAR(scene.camera.altitude, Scene{}.camera.altitude, 1e-9);
}

TEST(CameraControl, PassesOverAPoleWithoutATwist) {
  Scene scene;
  scene.camera.latitude = 85.0;
  CameraControl control;
  const View view;
  for (int i = 0; i < 200; ++i) {
    const Pose before = pose_of(scene, view);
    control.drag(scene, view, {0.0, 10.0});
    const Pose after = pose_of(scene, view);
    ASSERT_LT(glm::distance(before.up, after.up), 0.05) << scene.camera.latitude;
    ASSERT_LT(glm::distance(before.right, after.right), 0.02);
  }
  EXPECT_LT(scene.camera.latitude, 80.0);  // down on the other side
}

TEST(CameraControl, KeepsTheGroundUnderTheCursorWhileZooming) {
  Scene scene;
  scene.terrain.height = 0.0;
  scene.water.level = 0.0;
  const View view;
  const glm::dvec2 cursor(700.0, 300.0);
  CameraControl control;
  const auto under_cursor = [&] {
    const Pose pose = pose_of(scene, view);
    const glm::dvec3 ray = ray_through(pose, view, cursor);
    const double along = -glm::dot(pose.eye, ray);
    const glm::dvec3 foot = pose.eye + along * ray;
    return pose.eye + (along - std::sqrt(1.0 - glm::dot(foot, foot))) * ray;
  };
  const glm::dvec3 before = under_cursor();
  for (int i = 0; i < 5; ++i) control.zoom_now(scene, view, 1.05, cursor);
  // A few pixels of a thousandth of a radius each.
  EXPECT_LT(glm::distance(before, under_cursor()), 0.03);
}

TEST(CameraControl, ATwistTurnsThePictureWithTheFingers) {
  Scene scene;
  const View view;
  CameraControl control;
  const Pose before = pose_of(scene, view);
  control.roll(scene, 0.3);
  const Pose after = pose_of(scene, view);
  EXPECT_NEAR(glm::distance(before.eye, after.eye), 0.0, 1e-12);
  EXPECT_NEAR(glm::distance(before.forward, after.forward), 0.0, 1e-9);
  // What was up stands clockwise of it now, to the right.
  EXPECT_NEAR(glm::dot(before.up, after.right), std::sin(0.3), 1e-9);
  EXPECT_NEAR(glm::dot(before.up, after.up), std::cos(0.3), 1e-9);
}

TEST(CameraControl, ATwistLeavesTheHorizonWhereItIs) {
  Scene scene;
  CameraControl control;
  for (const double pitch : {0.0, 30.0}) {
    scene.camera.pitch = pitch;
    control.roll(scene, 0.5);
    EXPECT_EQ(scene.camera.heading, Scene{}.camera.heading);
  }
}

TEST(CameraControl, ZoomsDownToWalkingHeightAndNoFurther) {
  for (const char* kind : {"default", "steep"}) {
    Scene scene;
    if (kind[0] == 's') scene.terrain.height = 0.5;
    CameraControl control;
    const View view;
    test::Places places(1U);
    for (int i = 0; i < 300; ++i) {
      control.zoom_now(scene, view, 1.2, {places.between(0.0, 1280.0), places.between(0.0, 720.0)});
      control.drag(scene, view, {places.between(-50.0, 50.0), places.between(-50.0, 50.0)});
      control.tick(scene, view, 0.016);
      const Pose pose = pose_of(scene, view);
      ASSERT_GE(pose.clearance, 0.99 * least_clearance(scene));
    }
    EXPECT_LT(pose_of(scene, view).clearance, 0.02);
  }
}

TEST(CameraControl, RunsOnAfterAThrowAndComesToRest) {
  Scene scene;
  CameraControl control;
  control.drag(scene, {}, {8.0, 3.0});
  control.release(0.016);
  EXPECT_TRUE(control.moving());
  int ticks = 0;
  while (control.moving() && ticks < 1000) {
    EXPECT_TRUE(control.tick(scene, {}, 0.016));
    ++ticks;
  }
  EXPECT_GT(ticks, 10);
  EXPECT_LT(ticks, 500);
  EXPECT_FALSE(control.tick(scene, {}, 0.016));
}

TEST(CameraControl, StandsStillAfterARest) {
  Scene scene;
  CameraControl control;
  control.drag(scene, {}, {8.0, 3.0});
  control.release(0.5);
  EXPECT_FALSE(control.moving());
}

TEST(CameraControl, KeepsEveryParameterInItsRange) {
  Scene scene;
  CameraControl control;
  test::Places places(2U);
  const View view;
  for (int i = 0; i < 2000; ++i) {
    control.drag(scene, view, {places.between(-400.0, 400.0), places.between(-400.0, 400.0)});
    control.look(scene, view, {places.between(-400.0, 400.0), places.between(-400.0, 400.0)});
    control.roll(scene, places.between(-3.0, 3.0));
    control.zoom_now(scene, view, places.between(0.5, 2.0), {places.between(0.0, 1280.0), places.between(0.0, 720.0)});
    ASSERT_LE(std::fabs(scene.camera.latitude), 90.0);
    ASSERT_LE(std::fabs(scene.camera.longitude), 180.0);
    ASSERT_LE(std::fabs(scene.camera.heading), 360.0);
    ASSERT_LE(std::fabs(scene.camera.pitch), 90.0);
    ASSERT_GE(scene.camera.altitude, 0.0);
    ASSERT_TRUE(std::isfinite(scene.camera.altitude));
  }
}

}  // namespace
}  // namespace terrella
