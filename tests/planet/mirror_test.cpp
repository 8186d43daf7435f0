#include "planet/mirror.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "scene/presets.hpp"

namespace terrella {
namespace {

Scene fjords() { return find_preset("fjords")->scene; }

// The place of a picture, -1..1 from the middle, where something from the eye is seen.
glm::dvec2 seen_at(const glm::mat4& clip, const glm::dvec3& from_eye) {
  const glm::vec4 place = clip * glm::vec4(from_eye, 1.0);
  return glm::dvec2(place) / double{place.w};
}

TEST(Mirror, ShowsWaterWhereThePictureDoesStandingOnItsHead) {
  Scene scene = fjords();
  scene.camera.pitch = -20.0;
  scene.camera.roll = 10.0;
  View view;
  view.shift = {100.0, -60.0};  // past a panel
  const Pose pose = pose_of(scene, view);
  const Mirror mirror = mirror_of(scene, pose, view);
  EXPECT_EQ(mirror.view.width, view.width / 2);
  EXPECT_NEAR(mirror.height * scene.planet.radius, 15.0, 1e-6);
  const glm::mat4 clip = clip_from_eye(pose, view, depth_scheme(pose, true)), mirrored = clip_in_mirror(mirror);
  for (double y = 400.0; y < 720.0; y += 50.0) {
    for (double x = 0.0; x <= 1280.0; x += 320.0) {
      const glm::dvec3 ray = ray_through(pose, view, {x, y});
      const glm::dvec3 water = ray * (mirror.height / -glm::dot(ray, glm::normalize(pose.eye)));
      const glm::dvec2 there = seen_at(mirrored, water), here = seen_at(clip, water);
      EXPECT_NEAR(there.x, here.x, 1e-5);
      EXPECT_NEAR(there.y, -here.y, 1e-5);
    }
  }
}

// What a ray from the water meets lies on the straight line from the mirrored eye through that place.
TEST(Mirror, ShowsAlongARayWhatStillWaterMirrors) {
  const Scene scene = fjords();
  const View view;
  const Pose pose = pose_of(scene, view);
  const Mirror mirror = mirror_of(scene, pose, view);
  const glm::mat4 mirrored = clip_in_mirror(mirror);
  const glm::dvec3 plumb = glm::normalize(pose.eye);
  const glm::dvec3 ray = ray_through(pose, view, {900.0, 500.0});
  const glm::dvec3 water = ray * (mirror.height / -glm::dot(ray, plumb));
  for (const double way : {0.0, 1e-6, 1e-4, 0.01}) {
    const glm::dvec2 there = seen_at(mirrored, water + way * glm::reflect(ray, plumb));
    EXPECT_NEAR(there.x, seen_at(mirrored, water).x, 1e-5) << way;
    EXPECT_NEAR(there.y, seen_at(mirrored, water).y, 1e-5) << way;
  }
}

TEST(Mirror, IsThatOfAllThePictureInEachOfItsTiles) {
  const Scene scene = fjords();
  View whole, tile;
  whole.whole = tile.whole = {1280, 720, 1.0};
  tile.width = 300;
  tile.height = 200;
  tile.field = 200.0 / 720.0;
  tile.shift = {490.0, -260.0};
  const glm::mat4 of_whole = clip_in_mirror(mirror_of(scene, pose_of(scene, whole), whole));
  const glm::mat4 of_tile = clip_in_mirror(mirror_of(scene, pose_of(scene, tile), tile));
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) EXPECT_NEAR(of_whole[column][row], of_tile[column][row], 1e-6);
  }
}

}  // namespace
}  // namespace terrella
