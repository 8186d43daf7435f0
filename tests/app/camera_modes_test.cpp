#include "camera_places.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

using test::Held;

constexpr CameraMode all_modes[] = {CameraMode::orbit, CameraMode::fly, CameraMode::walk};

TEST(CameraModes, ASwitchByItselfMovesNothing) {
  for (const CameraMode from : all_modes) {
    for (const CameraMode to : all_modes) {
      Scene scene = test::earth();
      scene.camera.roll = 20.0;
      CameraControl control;
      control.set_mode(from);
      const auto before = scene.camera;
      control.set_mode(to);
      EXPECT_EQ(control.mode(), to);
      EXPECT_TRUE(scene.camera == before);
      EXPECT_FALSE(control.tick(scene, {}, 0.0));
    }
  }
}

// In a frame the eye moves by a part of its clearance, and by what people do by themselves; the view turns a little.
TEST(CameraModes, NothingJumpsAfterASwitch) {
  test::Places places(11U);
  for (const double radius : {1.0, 6.371e6, 1e8}) {
    Scene scene = test::hilly_planet(radius, 0.01 * radius, 0.001 * radius);
    CameraControl control;
    for (int i = 0; i < 60; ++i) {
      control.push({.right = places.between(-1.0, 1.0),
                    .ahead = places.between(-1.0, 1.0),
                    .up = places.between(-1.0, 1.0),
                    .turn = places.between(-1.0, 1.0),
                    .tilt = places.between(-1.0, 1.0),
                    .jump = i % 4 == 0});
      for (int frame = 0; frame < 20; ++frame) control.tick(scene, {}, 1.0 / 60.0);
      control.push({});
      Pose before = pose_of(scene, {});
      control.set_mode(all_modes[static_cast<std::size_t>(places.between(0.0, 2.999))]);
      for (int frame = 0; frame < 40; ++frame) {
        control.tick(scene, {}, 1.0 / 60.0);
        const Pose after = pose_of(scene, {});
        const double most = 0.04 * before.clearance + 56.0 / 60.0 * human_metre(scene);
        ASSERT_LT(glm::distance(before.eye, after.eye), most) << "switch " << i << ", frame " << frame;
        ASSERT_LT(glm::distance(before.forward, after.forward), 0.06);
        ASSERT_LT(glm::distance(before.up, after.up), 0.2);
        before = after;
      }
    }
  }
}

TEST(CameraModes, WalkingLevelsTheRollAtOnceAndOrbitAsSoonAsAHandMoves) {
  Scene scene = test::bare_planet(1.0);
  test::stand(scene);
  scene.camera.roll = 40.0;
  Held orbit(scene, CameraMode::orbit);
  orbit.hold({}, 1.0);
  EXPECT_EQ(scene.camera.roll, 40.0);
  EXPECT_FALSE(orbit.control.moving());
  orbit.control.drag(scene, {}, {1.0, 0.0});
  orbit.hold({}, 0.1);
  EXPECT_GT(scene.camera.roll, 20.0);  // gently
  orbit.hold({}, 2.0);
  EXPECT_EQ(scene.camera.roll, 0.0);
  EXPECT_FALSE(orbit.control.moving());

  scene.camera.roll = -40.0;
  Held flight(scene, CameraMode::fly);
  flight.hold({.ahead = 1.0}, 1.0);
  EXPECT_EQ(scene.camera.roll, -40.0);

  Held walk(scene, CameraMode::walk);
  walk.hold({}, 0.3);
  EXPECT_NEAR(scene.camera.roll, 0.0, 1.0);
  walk.hold({}, 0.7);
  EXPECT_EQ(scene.camera.roll, 0.0);
}

TEST(CameraModes, ThePlanetFollowsTheHandInOrbitHoweverFarTheCameraRolls) {
  for (const double roll : {-90.0, 0.0, 60.0, 180.0}) {
    Scene scene = test::bare_planet(1.0);
    scene.camera.pitch = -90.0;
    scene.camera.roll = roll;
    const Pose before = pose_of(scene, {});
    CameraControl control;
    control.drag(scene, {}, {10.0, 0.0});
    const glm::dvec3 moved = test::eye_of(scene) - before.eye;
    EXPECT_LT(glm::dot(moved, before.right), 0.0) << roll;
    EXPECT_NEAR(glm::dot(moved, before.up), 0.0, 1e-9) << roll;
  }
}

TEST(CameraModes, AHandOnTheMouseDoesNotStopAFlight) {
  Scene scene = test::bare_planet(1.0);
  Held flight(scene, CameraMode::fly);
  flight.hold({.ahead = 1.0}, 1.0);
  flight.control.push({});
  flight.control.hold();
  EXPECT_TRUE(flight.control.moving());
}

TEST(CameraModes, ShiftAloneMovesNothing) {
  CameraControl control;
  control.push({.fast = true});
  EXPECT_FALSE(control.pushed());
  EXPECT_FALSE(control.moving());
}

TEST(CameraModes, WhoWouldFallInAnotherSceneOrbitsIt) {
  Scene scene = test::bare_planet(1.0);
  CameraControl control;
  control.set_mode(CameraMode::walk);
  test::stand(scene);
  control.scene_replaced(scene);
  EXPECT_EQ(control.mode(), CameraMode::walk);
  control.scene_replaced(Scene{});
  EXPECT_EQ(control.mode(), CameraMode::orbit);
  control.set_mode(CameraMode::fly);
  control.scene_replaced(Scene{});
  EXPECT_EQ(control.mode(), CameraMode::fly);
}

TEST(CameraModes, FeetStayOnTheGroundUnderTwoFingersAndTheWheel) {
  Scene scene = test::bare_planet(1.0);
  test::stand(scene);
  CameraControl control;
  control.set_mode(CameraMode::walk);
  const auto before = scene.camera;
  control.zoom_now(scene, {}, 0.5, {});
  control.zoom(0.5, {});
  control.tick(scene, {}, 0.1);
  EXPECT_TRUE(scene.camera == before);
}

}  // namespace
}  // namespace terrella
