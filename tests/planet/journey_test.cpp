#include "planet/journey.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "laws/random_places.hpp"
#include "planet/pose.hpp"

namespace terrella {
namespace {

Scene bare_planet() {
  Scene scene;
  scene.terrain.model = scene.water.model = 0;
  return scene;
}

PathView view(double latitude, double longitude, double altitude, std::optional<double> at = std::nullopt) {
  PathView made;
  made.camera.latitude = latitude;
  made.camera.longitude = longitude;
  made.camera.altitude = altitude;
  made.at = at;
  return made;
}

glm::dvec3 eye(const Camera& camera) {
  return (1.0 + camera.altitude) * direction_of(camera.latitude, camera.longitude);
}

// From orbit to the ground, over the ground, to another place and back up.
const std::vector<PathView> round_trip = {view(0.0, 0.0, 5.0), view(20.0, 10.0, 0.02), view(21.0, 11.0, 0.02),
                                          view(40.0, 120.0, 0.05), view(40.0, 120.0, 3.0)};

TEST(Journey, LeadsThroughItsViewsAtTheirTimes) {
  std::vector<PathView> views = round_trip;
  for (std::size_t i = 0; i < views.size(); ++i) views[i].at = 4.0 * static_cast<double>(i * i);
  const Journey journey(bare_planet(), views);
  EXPECT_EQ(journey.seconds(), 64.0);
  EXPECT_EQ(journey.at(0.0), views.front().camera);
  EXPECT_EQ(journey.at(64.0), views.back().camera);
  EXPECT_EQ(journey.at(-1.0), views.front().camera);
  EXPECT_EQ(journey.at(1e9), views.back().camera);
  for (const PathView& each : views) {
    EXPECT_LT(glm::distance(eye(journey.at(*each.at)), eye(each.camera)), 1e-12);
    EXPECT_NEAR(journey.at(*each.at).altitude / each.camera.altitude, 1.0, 1e-12);
  }
}

TEST(Journey, TakesAsLongAsOneLikesToLookAtIt) {
  const Journey journey(bare_planet(), std::vector{view(0.0, 0.0, 10.0), view(0.0, 0.0, 0.001), view(0.0, 0.0, 0.001)});
  const double down = std::log(1e4) / Glide::curvature;
  EXPECT_NEAR(journey.seconds(), down + 1.0, 1e-12);
  // A second of rest at the end of it.
  EXPECT_NEAR(journey.at(down).altitude, 0.001, 1e-12);
  EXPECT_GT(journey.at(down - 0.5).altitude, 0.0011);
}

TEST(Journey, SpreadsTimesThatNobodyTells) {
  const Scene scene = bare_planet();
  const Journey journey(
      scene, std::vector{view(0.0, 0.0, 1.0), view(0.0, 0.0, 0.1), view(0.0, 0.0, 0.001, 30.0), view(0.0, 0.0, 0.1)});
  EXPECT_NEAR(journey.at(10.0).altitude, 0.1, 1e-12);  // a third of the logarithms
  EXPECT_NEAR(journey.seconds(), 30.0 + std::log(100.0) / Glide::curvature, 1e-12);
}

// Neither the place nor the way one looks nor the velocity jumps, wherever it is looked at.
TEST(Journey, IsSmooth) {
  std::vector<PathView> views = round_trip;
  views[1].camera.pitch = -20.0;
  views[2].camera.heading = 90.0;
  const Journey journey(bare_planet(), views);
  const double step = 1e-3;
  const auto velocity = [&](double at) {
    const Camera a = journey.at(at - 0.5 * step), b = journey.at(at + 0.5 * step);
    return (eye(b) - eye(a)) / (step * std::min(a.altitude, b.altitude));
  };
  const auto turning = [&](double at) {
    const Camera a = journey.at(at - 0.5 * step), b = journey.at(at + 0.5 * step);
    return glm::dvec2(std::remainder(b.heading - a.heading, 360.0), b.pitch - a.pitch) / step;
  };
  double fastest = 0.0;
  for (double at = step; at < journey.seconds() - 2.0 * step; at += step) {
    fastest = std::max(fastest, glm::length(velocity(at)));
    EXPECT_LT(glm::distance(velocity(at), velocity(at + step)), 0.01) << at << " of " << journey.seconds();
    EXPECT_LT(glm::distance(turning(at), turning(at + step)), 0.5) << at << " of " << journey.seconds();
  }
  EXPECT_GT(fastest, 1.0);
  EXPECT_LT(fastest, 1.5 * 1.5 * Glide::curvature);
}

TEST(Journey, BeginsAndEndsAtRestAndFliesThroughTheRest) {
  const Journey journey(bare_planet(),
                        std::vector{view(0.0, 0.0, 0.1, 0.0), view(0.0, 1.0, 0.1, 4.0), view(0.0, 2.0, 0.1, 8.0)});
  const auto speed = [&](double at) {
    return glm::distance(eye(journey.at(at - 5e-4)), eye(journey.at(at + 5e-4))) / 1e-3;
  };
  EXPECT_LT(speed(5e-4), 1e-4);
  EXPECT_LT(speed(8.0 - 5e-4), 1e-4);
  EXPECT_NEAR(speed(4.0), speed(3.0), 0.3 * speed(3.0));
}

// Also while it turns there, it does not drift past the place and back.
TEST(Journey, RestsBetweenViewsFromOnePlace) {
  for (const double heading : {0.0, 360.0, 90.0}) {
    std::vector<PathView> views = {view(0.0, 0.0, 1.0, 0.0), view(0.0, 0.0, 0.1, 5.0), view(0.0, 0.0, 0.1, 8.0),
                                   view(0.0, 50.0, 0.1, 12.0)};
    views[2].camera.heading = heading;
    const Journey journey(bare_planet(), views);
    for (double at = 5.0; at <= 8.0; at += 0.25) {
      EXPECT_LT(glm::distance(eye(journey.at(at)), eye(view(0.0, 0.0, 0.1).camera)), 1e-12);
    }
    EXPECT_NEAR(std::remainder(journey.at(6.5).heading - 0.5 * std::remainder(heading, 360.0), 360.0), 0.0, 1e-9);
    EXPECT_GT(journey.at(4.9).altitude, 0.1);
    EXPECT_GT(journey.at(8.3).longitude, 0.0);
  }
}

TEST(Journey, IsFiniteWhateverItsViews) {
  test::Places places(1U);
  for (int i = 0; i < 60; ++i) {
    std::vector<PathView> views;
    for (int n = 0; n < 5; ++n) {
      views.push_back(view(n % 2 == 0 ? 90.0 : places.between(-90.0, 90.0), places.between(-180.0, 180.0),
                           std::pow(10.0, places.between(-6.0, 12.0))));
      if (i % 3 == 0 && n > 2) views[static_cast<std::size_t>(n)].camera = views[0].camera;
    }
    const Journey journey(bare_planet(), views);
    for (int n = 0; n <= 100; ++n) {
      const Camera at = journey.at(journey.seconds() * n / 100.0);
      ASSERT_TRUE(std::isfinite(at.latitude + at.longitude + at.altitude + at.heading + at.pitch + at.fov));
      ASSERT_TRUE(at.altitude >= 0.0 && at.altitude <= 1e12);
    }
  }
}

}  // namespace
}  // namespace terrella
