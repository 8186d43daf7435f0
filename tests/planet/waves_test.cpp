#include "planet/waves.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

namespace terrella {
namespace {

Scene stormy(int count) {
  Scene scene;
  scene.waves.count = count;
  return scene;
}

TEST(Sea, HasAsManyWavesAsAsked) {
  for (const int count : {0, 1, 8, 100})
    EXPECT_EQ(make_sea(stormy(count), 0.0).waves.size(), static_cast<std::size_t>(count));
  Scene flat = stormy(8);
  flat.waves.amplitude = 0.0;
  EXPECT_TRUE(make_sea(flat, 0.0).waves.empty());
}

TEST(Sea, KeepsItsHeightWhateverTheNumberOfWaves) {
  for (const int count : {1, 8, 100}) {
    const Scene scene = stormy(count);
    double squares = 0.0;
    for (const f64::Wave& wave : make_sea(scene, 0.0).waves) squares += wave.amplitude * wave.amplitude;
    EXPECT_NEAR(std::sqrt(squares), scene.waves.amplitude, 1e-6);
  }
}

TEST(Sea, NeverFoldsAndSaysWhenItWasHeld) {
  for (const double length : {1e-3, 0.02, 0.16, 1.0}) {
    for (const double steepness : {0.0, 0.5, 1.0}) {
      Scene scene = stormy(20);
      scene.waves.length = length;
      scene.waves.steepness = steepness;
      const Sea sea = make_sea(scene, 0.0);
      double sum = 0.0;
      for (const f64::Wave& wave : sea.waves) sum += wave.pinch * wave.wavenumber;
      EXPECT_LT(sum, 0.951);
      EXPECT_EQ(sea.held, sea.steepness < steepness);
    }
  }
  EXPECT_TRUE(make_sea(
                  [] {
                    Scene s = stormy(20);
                    s.waves.length = 1e-3;
                    return s;
                  }(),
                  0.0)
                  .held);
}

TEST(Sea, PhasesStayWithinATurnAndExactAfterThirtyYears) {
  const Scene scene = stormy(10);
  const double years = 1e9;
  const Sea late = make_sea(scene, years), later = make_sea(scene, years + 0.01);
  for (std::size_t i = 0; i < late.waves.size(); ++i) {
    EXPECT_LE(std::fabs(late.waves[i].phase), 3.1416F);
    // A hundredth of a second moves the phase by what it did in the first second.
    const Sea early = make_sea(scene, 0.0), early_later = make_sea(scene, 0.01);
    const double step = std::remainder(double{later.waves[i].phase} - double{late.waves[i].phase}, 6.283185307179586);
    const double first =
        std::remainder(double{early_later.waves[i].phase} - double{early.waves[i].phase}, 6.283185307179586);
    EXPECT_NEAR(step, first, 2e-5);
  }
}

TEST(Sea, SpreadDecidesHowFarDirectionsDiffer) {
  Scene combed = stormy(20), wild = stormy(20);
  combed.waves.spread = 0.0;
  wild.waves.spread = 1.0;
  const auto closest = [](const Sea& sea) {
    double least = 1.0;
    for (const f64::Wave& wave : sea.waves) least = std::fmin(least, glm::dot(wave.origin, sea.waves[0].origin));
    return least;
  };
  EXPECT_GT(closest(make_sea(combed, 0.0)), 0.9999);
  EXPECT_LT(closest(make_sea(wild, 0.0)), 0.0);
}

TEST(Sea, IsTheSameForTheSameSeed) {
  Scene scene = stormy(10), other = stormy(10);
  other.waves.seed = 2;
  EXPECT_EQ(make_sea(scene, 3.0).waves[4].origin, make_sea(scene, 3.0).waves[4].origin);
  EXPECT_NE(make_sea(scene, 3.0).waves[4].origin, make_sea(other, 3.0).waves[4].origin);
}

}  // namespace
}  // namespace terrella
