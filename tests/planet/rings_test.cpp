#include "planet/rings.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include <glm/geometric.hpp>

#include "planet/pose.hpp"

namespace terrella {
namespace {

Scene ringed() {
  Scene scene;
  scene.rings.density = 1.0;
  return scene;
}

TEST(HasRings, NeedsMatterAndRoomForIt) {
  EXPECT_FALSE(has_rings(Scene{}));
  EXPECT_TRUE(has_rings(ringed()));
  Scene inside_out = ringed();
  inside_out.rings.outer = inside_out.rings.inner;
  EXPECT_FALSE(has_rings(inside_out));
  EXPECT_EQ(rings_radius(inside_out), 0.0);
}

TEST(RingShadeAround, DarkensTheGroundUnderTheShadowButNothingFromOutside) {
  Scene scene = ringed();
  scene.sun.latitude = 20.0;
  scene.sun.longitude = 0.0;
  double darkest = 1.0;
  for (double latitude = -40.0; latitude < 0.0; latitude += 0.5) {
    darkest = std::min(darkest, ring_shade_around(scene, direction_of(latitude, 0.0)));
    EXPECT_EQ(ring_shade_around(scene, 1.5 * direction_of(latitude, 0.0)), 1.0);
    EXPECT_EQ(ring_shade_around(Scene{}, direction_of(latitude, 0.0)), 1.0);
  }
  EXPECT_LT(darkest, 0.05);
  EXPECT_EQ(ring_shade_around(scene, direction_of(30.0, 0.0)), 1.0);
}

TEST(Pose, SeesRingsToTheirFarEdge) {
  Scene scene = ringed();
  const Pose pose = pose_of(scene, View{});
  EXPECT_GT(pose.far, glm::length(pose.eye) + scene.rings.outer);
  EXPECT_LT(pose.near, glm::length(pose.eye) - scene.rings.outer);
  EXPECT_EQ(outermost_radius(scene), scene.rings.outer);
}

}  // namespace
}  // namespace terrella
