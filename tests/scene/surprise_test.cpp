#include "scene/surprise.hpp"

#include <gtest/gtest.h>

#include "random_scene.hpp"
#include "scene/view_groups.hpp"

namespace terrella {
namespace {

constexpr std::uint32_t tries = 60;

Locks all_but(std::string_view group) {
  Locks locks;
  for (const Parameter& parameter : parameters()) {
    if (parameter.group != group) locks.insert(parameter.path);
  }
  return locks;
}

// Paths in which two scenes differ.
Locks differences(const Scene& a, const Scene& b) {
  Locks paths;
  for (const Parameter& parameter : parameters()) {
    if (parameter.get(a) != parameter.get(b)) paths.insert(parameter.path);
  }
  return paths;
}

TEST(Surprise, IsTheSameForTheSameSeedAndAnotherForAnother) {
  for (std::uint32_t seed = 0; seed < tries; ++seed) {
    EXPECT_EQ(surprise({}, {}, seed), surprise({}, {}, seed));
    EXPECT_NE(surprise({}, {}, seed), surprise({}, {}, seed + 1));
  }
}

TEST(Surprise, ChangesEveryParameterOfThePlanetSoonerOrLaterAndNoneOfTheView) {
  // What no preset changes cannot be drawn.
  const auto told_by_a_preset = [](const Parameter& parameter) {
    return std::any_of(presets().begin(), presets().end(),
                       [&](const Preset& preset) { return parameter.get(preset.scene) != parameter.default_value; });
  };
  Locks changed;
  for (std::uint32_t seed = 0; seed < 200; ++seed) changed.merge(differences({}, surprise({}, {}, seed)));
  for (const Parameter& parameter : parameters()) {
    const bool may = is_for_chance(parameter) && (told_by_a_preset(parameter) || parameter.is_seed());
    EXPECT_EQ(changed.contains(parameter.path), may) << parameter.path;
  }
}

TEST(Surprise, StaysInRangeFromAnyScene) {
  Random random(5);
  for (std::uint32_t seed = 0; seed < tries; ++seed) {
    Scene scene = random_document(random).scene;
    if (seed % 2 == 0) scene.planet.radius = find_parameter("planet.radius")->max;
    Locks locks;
    for (const Parameter& parameter : parameters()) {
      if (random_int(random, 0, 3) == 0) locks.insert(parameter.path);
    }
    const Scene drawn = surprise(scene, locks, seed);
    Scene copy;
    for (const Parameter& parameter : parameters()) {
      const auto issue = assign(copy, parameter, parameter.get(drawn));
      EXPECT_FALSE(issue) << issue->text();
      if (locks.contains(parameter.path)) {
        EXPECT_EQ(parameter.get(drawn), parameter.get(scene)) << parameter.path;
      }
    }
  }
}

TEST(Surprise, ALockChangesNothingElse) {
  for (std::uint32_t seed = 0; seed < tries; ++seed) {
    const Scene free = surprise({}, {}, seed);
    for (const Parameter& parameter : parameters()) {
      if (parameter.path == "terrain.height" || parameter.path == "water.level") continue;
      Scene expected = free;
      assign(expected, parameter, parameter.get(Scene{}));
      ASSERT_EQ(surprise({}, {parameter.path}, seed), expected) << parameter.path;
    }
  }
}

TEST(Surprise, OfOneGroupLeavesTheOthers) {
  for (const Group& group : groups()) {
    for (std::uint32_t seed = 0; seed < tries; ++seed) {
      for (const std::string_view path : differences({}, surprise({}, all_but(group.name), seed))) {
        EXPECT_EQ(find_parameter(path)->group, group.name) << path;
      }
    }
  }
}

TEST(Surprise, OfWavesMakesWavesAsOftenAsNot) {
  int with_waves = 0;
  for (std::uint32_t seed = 0; seed < 200; ++seed) with_waves += surprise({}, {}, seed).waves.count > 0 ? 1 : 0;
  EXPECT_GT(with_waves, 60);
  EXPECT_LT(with_waves, 180);
}

TEST(Surprise, LooksTheSameOnAPlanetOfAnySize) {
  Scene large;
  large.planet.radius = 6e6;
  for (std::uint32_t seed = 0; seed < tries; ++seed) {
    const Scene small = surprise({}, {}, seed), drawn = surprise(large, {}, seed);
    EXPECT_EQ(drawn.planet.radius, 6e6);
    EXPECT_NEAR(drawn.terrain.height / 6e6, small.terrain.height, 1e-12);
    EXPECT_NEAR(drawn.waves.speed / 6e6, small.waves.speed, 1e-12);
    EXPECT_EQ(drawn.clouds.coverage, small.clouds.coverage);
  }
}

TEST(Surprise, TheSunStandsBesideTheCamera) {
  Scene turned;
  turned.camera.longitude = 150.0;
  for (std::uint32_t seed = 0; seed < tries; ++seed) {
    const double here = surprise({}, {}, seed).sun.longitude, there = surprise(turned, {}, seed).sun.longitude;
    EXPECT_NEAR(std::remainder(there - here - 150.0, 360.0), 0.0, 1e-9);
    EXPECT_LT(std::abs(here), 120.0);  // some of the day is in sight
  }
}

// How high the sea stands on the mountains decides how much of them is land.
TEST(Surprise, HeightAndLevelFitEachOtherWhereOneIsLocked) {
  for (std::uint32_t seed = 0; seed < tries; ++seed) {
    const Scene free = surprise({}, {}, seed);
    const double ratio = free.water.level / free.terrain.height;
    for (const std::string_view path : {"terrain.height", "water.level"}) {
      const Scene drawn = surprise({}, {path}, seed);
      const double factor = drawn.water.level / drawn.terrain.height / ratio;
      const double asked =
          path == "water.level" ? Scene{}.water.level / free.water.level : Scene{}.terrain.height / free.terrain.height;
      if (asked < 0.5 || asked > 2.0) continue;
      EXPECT_NEAR(factor, 1.0, 1e-9) << path << ' ' << seed;
    }
  }
}

}  // namespace
}  // namespace terrella
