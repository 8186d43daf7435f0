#include "planet/pose.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "laws/random_places.hpp"
#include "planet/spheres.hpp"
#include "planet/terrain.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

TEST(Pose, LooksAtTheCentreByDefaultAndLevelAtPitchZero) {
  Scene scene;
  Pose pose = pose_of(scene, {});
  EXPECT_NEAR(glm::dot(pose.forward, glm::normalize(pose.eye)), -1.0, 1e-12);
  scene.camera.pitch = 0.0;
  pose = pose_of(scene, {});
  EXPECT_NEAR(glm::dot(pose.forward, glm::normalize(pose.eye)), 0.0, 1e-12);
}

TEST(Pose, HeadingTurnsClockwiseFromNorth) {
  Scene scene;
  scene.camera.pitch = 0.0;
  scene.camera.latitude = scene.camera.longitude = 0.0;
  EXPECT_GT(pose_of(scene, {}).forward.z, 0.999);  // north
  scene.camera.heading = 90.0;
  EXPECT_GT(pose_of(scene, {}).forward.y, 0.999);  // east of x is y
}

TEST(Pose, RollLeansToTheRightAndLeavesWhatIsAhead) {
  Scene scene;
  scene.camera.pitch = -20.0;
  const Pose level = pose_of(scene, {});
  EXPECT_NEAR(glm::dot(level.right, glm::normalize(level.eye)), 0.0, 1e-15);
  scene.camera.roll = 30.0;
  const Pose leaning = pose_of(scene, {});
  EXPECT_EQ(leaning.forward, level.forward);
  EXPECT_NEAR(glm::dot(leaning.right, level.up), -0.5, 1e-12);  // the right wing is down
  EXPECT_NEAR(glm::dot(leaning.up, level.right), 0.5, 1e-12);
}

// Single precision would move in steps of 6e-8, and 0 between them.
TEST(Pose, SurfaceIsFoundFinerThanSinglePrecisionTellsPlaces) {
  Scene scene;
  scene.water.level = 0.0;
  double least = 1.0, most = -1.0;
  for (int i = 0; i < 50; ++i) {
    const double lat = 30.0, lon = 20.0 + 1e-7 * i, step = 5e-8;
    const double slope =
        (surface_radius(scene, direction_of(lat, lon + step)) - surface_radius(scene, direction_of(lat, lon))) /
        (step * 0.0174533);
    least = std::min(least, slope);
    most = std::max(most, slope);
  }
  EXPECT_LT(most - least, 0.5);
}

TEST(Pose, IsRightHandedAndUnitEverywhereAlsoAtThePoles) {
  test::Places places(1U);
  Scene scene;
  for (int i = 0; i < 500; ++i) {
    scene.camera.latitude = i % 5 == 0 ? 90.0 : i % 5 == 1 ? -90.0 : places.between(-90.0, 90.0);
    scene.camera.longitude = places.between(-180.0, 180.0);
    scene.camera.heading = places.between(-360.0, 360.0);
    scene.camera.pitch = places.between(-90.0, 90.0);
    scene.camera.roll = places.between(-180.0, 180.0);
    const Pose pose = pose_of(scene, {});
    EXPECT_NEAR(glm::length(pose.forward), 1.0, 1e-12);
    EXPECT_NEAR(glm::length(pose.right), 1.0, 1e-12);
    EXPECT_LT(glm::distance(glm::cross(pose.right, pose.forward), pose.up), 1e-12);
    EXPECT_NEAR(glm::dot(pose.right, pose.forward), 0.0, 1e-12);
  }
}

TEST(Pose, NeverStandsUnderGroundOrSea) {
  test::Places places(2U);
  for (const Preset& preset : presets()) {
    Scene scene = preset.scene;
    scene.camera.altitude = 0.0;
    for (int i = 0; i < 40; ++i) {
      scene.camera.latitude = places.between(-90.0, 90.0);
      scene.camera.longitude = places.between(-180.0, 180.0);
      const Pose pose = pose_of(scene, {});
      EXPECT_GE(glm::length(pose.eye), surface_radius(scene, glm::normalize(pose.eye)) + 0.99 * least_clearance(scene));
      EXPECT_TRUE(pose.raised);
    }
  }
}

Scene diver(double depth) {
  Scene scene = find_preset("lagoon")->scene;
  scene.water.dive = true;
  scene.camera.altitude = scene.water.level - depth;
  return scene;
}

TEST(Pose, GoesUnderWaterWhereItMayAndDownToTheGroundAtTheMost) {
  int places = 0;
  for (const char* name : {"lagoon", "temperate", "storm", "gale"}) {
    Scene scene = find_preset(name)->scene;
    const double radius = scene.planet.radius;
    const double ground = exact_ground_radius(
        exact_terrain_of(scene), direction_of(scene.camera.latitude, scene.camera.longitude), finest_footprint);
    const double depth = water_radius(scene) - ground;
    if (depth <= 0.0) continue;
    ++places;
    scene.camera.altitude = scene.water.level - 0.5 * depth * radius;
    EXPECT_TRUE(pose_of(scene, {}).raised) << name;
    scene.water.dive = true;
    const Pose pose = pose_of(scene, {});
    EXPECT_FALSE(pose.raised) << name;
    EXPECT_NEAR(glm::length(pose.eye), 1.0 + scene.camera.altitude / radius, 1e-12) << name;
    scene.camera.altitude = 0.0;
    const Pose deepest = pose_of(scene, {});
    EXPECT_TRUE(deepest.raised) << name;
    EXPECT_NEAR(glm::length(deepest.eye), surface_radius(scene, glm::normalize(deepest.eye)) + least_clearance(scene),
                1e-12)
        << name;
  }
  EXPECT_GE(places, 2);
}

// However far away the near plane is, and wherever the camera looks.
TEST(LensAboveWater, IsNotUnderWaterFromAfar) {
  for (const char* name : {"temperate", "storm", "lagoon"}) {
    Scene scene = find_preset(name)->scene;
    scene.water.dive = true;
    for (double altitude = 0.3; altitude < 1e3; altitude *= 2.0) {
      for (double pitch = -90.0; pitch <= 90.0; pitch += 5.0) {
        scene.camera.altitude = altitude * scene.planet.radius;
        scene.camera.pitch = pitch;
        EXPECT_FALSE(is_in_water(pose_of(scene, {}), {})) << name << ' ' << altitude << ' ' << pitch;
      }
    }
  }
}

TEST(LensAboveWater, IsNowhereInTheWaterWhereTheCameraMayNotDive) {
  Scene scene = diver(2.0);
  scene.water.dive = false;
  const Pose pose = pose_of(scene, {});
  EXPECT_EQ(lens_above_water(pose), pose.forward);
  EXPECT_FALSE(is_in_water(pose, {}));
}

// As the water rises over the lens, the line on it rises from its lower edge to the upper one.
TEST(LensAboveWater, RisesWithTheWater) {
  const View view;
  for (const double depth : {-20.0, -1.0, 0.0, 0.02, 0.04, 0.06, 0.08, 0.1, 1.0, 20.0}) {
    Scene scene = diver(depth);
    scene.waves.count = 0;
    scene.camera.pitch = 0.0;
    const Pose pose = pose_of(scene, view);
    const glm::dvec3 lens = lens_above_water(pose);
    EXPECT_NEAR(glm::length(lens), 1.0, 1e-12);
    // The tangent at which a ray in the middle passes from water into air.
    const double line = -glm::dot(lens, pose.forward) / std::max(glm::dot(lens, pose.up), 1e-12);
    const double edge = pose.tan_half_fov;
    EXPECT_EQ(is_all_in_water(pose, view), depth >= 0.06) << depth;
    EXPECT_EQ(is_in_water(pose, view), depth >= 0.0) << depth;
    if (is_in_water(pose, view) && !is_all_in_water(pose, view)) {
      // Where the still surface lies on the near plane.
      const double height = -depth / scene.planet.radius;
      EXPECT_NEAR(line, -height / pose.near, 1e-3 * edge) << depth;
    }
  }
}

TEST(Pose, DepthRangeHoldsThePlanetFromWalkingHeightToFarAway) {
  Scene scene;
  for (double altitude = 1e-4; altitude < 1e5; altitude *= 3.0) {
    scene.camera.altitude = altitude;
    const Pose pose = pose_of(scene, {});
    const double distance = glm::length(pose.eye);
    EXPECT_GT(pose.near, 0.0);
    EXPECT_LT(pose.near, pose.far);
    EXPECT_LE(pose.near, pose.clearance);
    // The horizon of the sphere lies before the far plane.
    EXPECT_GE(pose.far, std::sqrt((distance - 1.0) * (distance + 1.0)));
  }
}

TEST(ClipFromEye, AgreesWithTheRayThroughEveryPixel) {
  test::Places places(3U);
  Scene scene;
  for (const double fov : {1.0, 45.0, 170.0}) {
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(1280, 720), std::pair(10, 1000)}) {
      scene.camera.fov = fov;
      View view;
      view.width = width;
      view.height = height;
      view.shift = {places.between(-0.5, 0.5), places.between(-0.5, 0.5)};
      const Pose pose = pose_of(scene, view);
      const glm::dmat4 clip(clip_from_eye(pose, view, depth_scheme(pose, true)));
      for (int i = 0; i < 50; ++i) {
        const glm::dvec2 pixel(places.between(0.0, width), places.between(0.0, height));
        const glm::dvec3 ray = ray_through(pose, view, pixel);
        const glm::dvec4 at = clip * glm::dvec4(ray * 0.5 * (pose.near + pose.far), 1.0);
        EXPECT_NEAR((at.x / at.w + 1.0) * 0.5 * width, pixel.x, 0.01);
        EXPECT_NEAR((1.0 - at.y / at.w) * 0.5 * height, pixel.y, 0.01);
      }
    }
  }
}

// What the driver stores for a distance, as shaders/frame_block.glsl and the driver come to it.
float stored_depth(const DepthScheme& depths, const Pose& pose, float distance, bool from_zero) {
  const auto near = static_cast<float>(pose.near);
  const auto by_matrix = static_cast<float>(depths.scale) * distance + static_cast<float>(depths.offset * pose.near);
  const auto by_logarithm = distance * (1.0F - static_cast<float>(depths.log_factor) * std::log2(distance / near));
  const float z = (depths.log_factor > 0.0 ? by_logarithm : by_matrix) / distance;
  return from_zero ? z : 0.5F * z + 0.5F;
}

TEST(DepthScheme, TellsDistancesApartThatDifferByAThousandthFromAHandsBreadthToAThousandRadii) {
  Scene scene;
  scene.planet.radius = 1e8;
  for (const double altitude : {0.0, 1e-6, 1e-3, 1.0, 1000.0}) {
    scene.camera.altitude = altitude * scene.planet.radius;
    const Pose pose = pose_of(scene, {});
    for (const bool from_zero : {true, false}) {
      const DepthScheme depths = depth_scheme(pose, from_zero);
      float before = 2.0F;
      for (double distance = pose.near; distance < pose.far; distance *= 1.001) {
        const float depth = stored_depth(depths, pose, static_cast<float>(distance), from_zero);
        ASSERT_LT(depth, before) << distance << " of " << pose.near << ".." << pose.far << " from_zero " << from_zero;
        ASSERT_GE(depth, 0.0F);
        before = depth;
      }
    }
  }
}

TEST(DepthScheme, BeginsAtTheNearPlaneAndEndsAtInfinity) {
  const Pose pose = pose_of({}, {});
  for (const bool from_zero : {true, false}) {
    const DepthScheme depths = depth_scheme(pose, from_zero);
    EXPECT_NEAR(stored_depth(depths, pose, static_cast<float>(pose.near), from_zero), 1.0F, 1e-6F);
    EXPECT_NEAR(stored_depth(depths, pose, 1e12F, from_zero),
                from_zero ? 0.0F : 0.5F + 0.5F * static_cast<float>(depths.far_plane), 1e-6F);
  }
}

TEST(Pose, OfAnUprightWindowShowsAcrossWhatALowOneShowsUpright) {
  Scene scene;
  View wide, upright;
  wide.width = upright.height = 1280;
  wide.height = upright.width = 720;
  upright.field = 1280.0 / 720.0;
  const Pose a = pose_of(scene, wide), b = pose_of(scene, upright);
  EXPECT_NEAR(glm::dot(ray_through(a, wide, {640.0, 0.0}), a.forward),
              glm::dot(ray_through(b, upright, {0.0, 640.0}), b.forward), 1e-12);
}

TEST(Pose, AShiftMovesWhatIsSeenOfASphere) {
  Scene scene;
  View view;
  view.width = 390;
  view.height = 844;
  view.field = 844.0 / 390.0;
  view.shift = {20.0, -190.0};
  const Pose pose = pose_of(scene, view);
  const PictureBox box = box_of_sphere(pose, view, 1.0);
  EXPECT_NEAR(0.5 * (box.left + box.right) * view.width, 0.5 * view.width + 20.0, 1e-6);
  EXPECT_NEAR(0.5 * (box.bottom + box.top) * view.height, 0.5 * view.height + 190.0, 1e-6);
  EXPECT_LT(box.top, 1.0);
  for (const glm::dvec2 corner :
       {glm::dvec2(0.0, 0.0), glm::dvec2(390.0, 0.0), glm::dvec2(0.0, 844.0), glm::dvec2(390.0, 844.0)}) {
    EXPECT_GE(glm::dot(ray_through(pose, view, corner), pose.forward), std::cos(picture_half_angle(pose, view)) - 1e-9);
  }
}

TEST(SurfaceRadius, ScalesWithThePlanet) {
  Scene small, large;
  large.planet.radius *= 1024.0;
  large.terrain.height *= 1024.0;
  large.water.level *= 1024.0;
  test::Places places(4U);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 d = places.on_sphere();
    EXPECT_EQ(surface_radius(small, d), surface_radius(large, d));
  }
}

// Wherever the planet is in the picture, and however wide that is.
TEST(Pose, DepthRangeBeginsBeforeAllThatIsSeenOfThePlanet) {
  test::Places places(4U);
  int seen = 0;
  for (int i = 0; i < 400; ++i) {
    Scene scene;
    scene.camera.altitude = std::pow(10.0, places.between(-2.0, 2.0));
    scene.camera.pitch = places.between(-90.0, 0.0);
    scene.camera.fov = places.between(1.0, 170.0);
    View view;
    view.width = i % 3 == 0 ? 360 : 32;
    view.height = 18;
    const Pose pose = pose_of(scene, view);
    for (int pixel = 0; pixel < view.width * view.height; ++pixel) {
      const glm::dvec3 ray = ray_through(pose, view, {pixel % view.width + 0.5, pixel / view.width + 0.5});
      const double along = -glm::dot(pose.eye, ray), radius = water_radius(scene);
      const double half2 = radius * radius - glm::dot(pose.eye, pose.eye) + along * along;
      if (half2 < 0.0 || along < 0.0) continue;
      ++seen;
      EXPECT_GT((along - std::sqrt(half2)) * glm::dot(ray, pose.forward), pose.near);
    }
  }
  EXPECT_GT(seen, 100'000);
}

// From a little over them and from a little under them, a part of the clearance would cut them off.
TEST(Pose, DepthRangeBeginsBeforeTheClouds) {
  for (const double beside : {-0.02, -0.003, 0.003, 0.015, 0.02, 0.05}) {
    for (const double fov : {20.0, 45.0, 120.0}) {
      Scene scene;
      scene.clouds.height = 0.085;
      scene.camera.altitude = scene.clouds.height + beside;
      scene.camera.fov = fov;
      const View view;
      const Pose pose = pose_of(scene, view);
      ASSERT_FALSE(pose.raised);
      EXPECT_LT(pose.near, std::abs(beside) * std::cos(picture_half_angle(pose, view))) << beside << ' ' << fov;
    }
  }
}

// What lies higher than this would be cut off by the near end of the depths.
TEST(TopRadius, IsAboveGroundSeaAndIceEverywhere) {
  test::Places places(3U);
  std::vector<Scene> scenes;
  for (const Preset& preset : presets()) scenes.push_back(preset.scene);
  Scene low;  // where nothing but the ice around the poles rises over the sea
  low.terrain.height = 0.0;
  low.water.level = 1e-4;
  low.clouds.model = 0;
  scenes.push_back(low);
  for (const Scene& scene : scenes) {
    for (int i = 0; i < 200; ++i) {
      const glm::dvec3 place = direction_of(places.between(-90.0, 90.0), places.between(-180.0, 180.0));
      EXPECT_LE(surface_radius(scene, place), top_radius(scene) + 1e-7);
    }
  }
  EXPECT_GT(top_radius(low), water_radius(low));  // there is ice on it
}

TEST(PixelOfHeight, IsTheMostThatARadialChangeMayBe) {
  for (const double altitude : {1e-3, 0.3, 2.25, 40.0}) {
    Scene scene;
    scene.terrain.model = scene.water.model = 0;
    scene.camera.altitude = altitude;
    const Pose pose = pose_of(scene, {});
    const double moved = 1e-3 * pixel_of_height(pose);  // small: a thousandth of a pixel
    const double d = glm::length(pose.eye);
    double most = 0.0;
    for (int i = 1; i < 20000; ++i) {
      const double angle = std::acos(1.0 / d) * i / 20000.0;
      const auto seen_at = [&](double radius) {
        return std::atan2(radius * std::sin(angle), d - radius * std::cos(angle));
      };
      most = std::max(most, seen_at(1.0 + moved) - seen_at(1.0));
    }
    EXPECT_NEAR(most / (1e-3 * pose.pixel_angle), 1.0, 0.01) << altitude;
  }
}

}  // namespace
}  // namespace terrella
