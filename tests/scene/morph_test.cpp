#include "scene/morph.hpp"

#include <gtest/gtest.h>

#include "random_scene.hpp"
#include "scene/view_groups.hpp"

namespace terrella {
namespace {

double number(const Value& value) {
  if (const auto* whole = std::get_if<int>(&value)) return *whole;
  return std::get<double>(value);
}

bool is_number(const Parameter& parameter) { return parameter.type == Type::Float || parameter.type == Type::Int; }

std::string fault(const Parameter& parameter, const Scene& scene) {
  Scene copy;
  const auto issue = assign(copy, parameter, parameter.get(scene));
  return issue ? issue->text() : "";
}

TEST(Morph, EndsAreExact) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Scene from = random_document(random).scene, to = random_document(random).scene;
    EXPECT_EQ(morph(from, to, 0.0), from);
    EXPECT_EQ(morph(from, to, 1.0), to);
    EXPECT_EQ(morph(from, to, -0.5), from);
    EXPECT_EQ(morph(from, to, 1.5), to);
  }
}

TEST(Morph, OfASceneWithItselfIsThatScene) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Scene scene = random_document(random).scene;
    EXPECT_EQ(morph(scene, scene, 0.37), scene);
  }
}

TEST(Morph, IsValidAndRunsFromOneEndToTheOther) {
  Random random(3);
  for (int i = 0; i < 40; ++i) {
    const Scene from = random_document(random).scene;
    Scene to = random_document(random).scene;
    // Lengths near the ends of their range cannot follow a radius that changes.
    const bool same_size = i % 2 == 0;
    if (same_size) to.planet.radius = from.planet.radius;
    Scene last = from;
    for (double share = 0.0; share <= 1.0; share += 0.0625) {
      const Scene scene = morph(from, to, share);
      for (const Parameter& parameter : parameters()) {
        ASSERT_EQ(fault(parameter, scene), "");
        if (!is_number(parameter) || (!same_size && parameter.grows_with_planet())) continue;
        const double up = number(parameter.get(to)) >= number(parameter.get(from)) ? 1.0 : -1.0;
        ASSERT_GE(up * (number(parameter.get(scene)) - number(parameter.get(last))), 0.0)
            << parameter.path << " at " << share;
      }
      last = scene;
    }
  }
}

TEST(Morph, RunsAsSlidersDo) {
  Scene from, to;
  from.terrain.frequency = 1.0;  // logarithmic
  to.terrain.frequency = 100.0;
  from.terrain.power = 1.0;  // linear
  to.terrain.power = 3.0;
  from.terrain.octaves = 4;
  to.terrain.octaves = 8;
  const Scene half = morph(from, to, 0.5);
  EXPECT_NEAR(half.terrain.frequency, 10.0, 1e-12);
  EXPECT_EQ(half.terrain.power, 2.0);
  EXPECT_EQ(half.terrain.octaves, 6);
}

TEST(Morph, LengthsArePartsOfTheRadius) {
  Scene from, to;
  to.planet.radius = 1e6;
  to.terrain.height = 1e5;
  const Scene half = morph(from, to, 0.5);
  EXPECT_NEAR(half.planet.radius, 1e3, 1e-9);
  EXPECT_NEAR(half.terrain.height, 130.0, 1e-9);  // between 0.16 and 0.1 radii
}

TEST(Morph, ColorsMixAsLight) {
  Scene from, to;
  from.air.color = {0, 255, 10};
  to.air.color = {255, 0, 10};
  EXPECT_EQ(morph(from, to, 0.5).air.color, (Color{188, 188, 10}));  // half of the light
}

TEST(Morph, ChoicesSwitchesAndSeedsChangeAtTheHalf) {
  Scene from, to;
  to.water.shading = 1;
  to.terrain.ridged = true;
  to.planet.seed = 9;
  const Scene before = morph(from, to, 0.49), after = morph(from, to, 0.5);
  EXPECT_EQ(before.water.shading, 0);
  EXPECT_FALSE(before.terrain.ridged);
  EXPECT_EQ(before.planet.seed, from.planet.seed);
  EXPECT_EQ(after.water.shading, 1);
  EXPECT_TRUE(after.terrain.ridged);
  EXPECT_EQ(after.planet.seed, 9);
}

TEST(ViewGroups, ASceneIsSeenAsAnother) {
  Random random(4);
  const Scene scene = random_document(random).scene;
  Scene seen = random_document(random).scene;
  seen.planet.radius = 2.0 * scene.planet.radius;
  seen.camera.altitude = 1.0;
  const Scene both = seen_as(scene, seen);
  for (const Parameter& parameter : parameters()) {
    if (parameter.path == "camera.altitude") continue;
    EXPECT_EQ(parameter.get(both), parameter.get(is_of_view(parameter.group) ? seen : scene)) << parameter.path;
  }
  EXPECT_EQ(both.camera.altitude, 0.5);
}

}  // namespace
}  // namespace terrella
