#include "planet/sun.hpp"

#include <gtest/gtest.h>

namespace terrella {
namespace {

// From over the equator, looking at the horizon in the west, where the sun stands over a longitude.
struct West {
  explicit West(double sun_longitude) {
    scene.camera = {};
    scene.camera.latitude = 0.0;
    scene.camera.longitude = 0.0;
    scene.camera.altitude = 1.0;
    scene.camera.heading = -90.0;
    scene.camera.pitch = -60.0;  // seen from a radius over it, the limb lies 60 degrees below the level
    scene.sun.latitude = 0.0;
    scene.sun.longitude = sun_longitude;
    pose = pose_of(scene, view);
  }
  Scene scene;
  View view;
  Pose pose;
};

TEST(FreePartOfSun, IsAllOfItBesideThePlanetHalfOnItsLimbAndNothingBehindIt) {
  // The limb is seen towards longitude -150: 120 degrees from the point below the camera and 30 more.
  EXPECT_EQ(free_part_of_sun(West(-148.0).scene, West(-148.0).pose, 1.0), 1.0);
  EXPECT_NEAR(free_part_of_sun(West(-150.0).scene, West(-150.0).pose, 1.0), 0.5, 0.02);
  EXPECT_EQ(free_part_of_sun(West(-152.0).scene, West(-152.0).pose, 1.0), 0.0);
  EXPECT_EQ(free_part_of_sun(West(-180.0).scene, West(-180.0).pose, 0.0), 1.0);  // nothing is there to hide it
}

TEST(PixelAtSun, ShrinksAwayFromThePicturesMiddle) {
  const auto turned = [](double from_middle) {
    const West west(-150.0 + from_middle);  // the middle of the picture shows the limb
    return pixel_at_sun(west.scene, west.pose) / west.pose.pixel_angle;
  };
  EXPECT_NEAR(turned(0.0), 1.0, 1e-9);
  EXPECT_NEAR(turned(60.0), 0.25, 1e-9);
  EXPECT_GT(turned(180.0), 0.0);
  EXPECT_LT(turned(180.0), 0.01);
}

TEST(SunInPicture, CountsItsGlareWhereThereIsOne) {
  const West ahead(-150.0), beside(-90.0), behind(30.0);
  EXPECT_TRUE(sun_in_picture(ahead.scene, ahead.view, ahead.pose, false));
  EXPECT_FALSE(sun_in_picture(beside.scene, beside.view, beside.pose, false));
  EXPECT_TRUE(sun_in_picture(beside.scene, beside.view, beside.pose, true));
  EXPECT_FALSE(sun_in_picture(behind.scene, behind.view, behind.pose, true));
}

}  // namespace
}  // namespace terrella
