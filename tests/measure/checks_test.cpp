// Planted faults must be seen.
#include "measure/checks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "measure/cases.hpp"
#include "measure/cost.hpp"
#include "measure/studio.hpp"
#include "passes/frame.hpp"

namespace terrella {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

TEST(NonfinitePixels, AreCountedWhicheverChannelIsBroken) {
  std::vector<float> light(4 * 10, 0.5F);
  EXPECT_EQ(nonfinite_pixels(light), 0);
  light[4 * 3 + 1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(nonfinite_pixels(light), 1);
  light[4 * 3 + 2] = infinity;
  EXPECT_EQ(nonfinite_pixels(light), 1);
  light[4 * 9 + 3] = -infinity;
  EXPECT_EQ(nonfinite_pixels(light), 2);
}

struct Planet {
  test::Studio studio;
  View view;
  std::vector<float> distance;

  Planet() {
    view.width = 32;
    view.height = 18;
    Scene scene;
    make_cheap(scene);
    studio.renderer.draw(scene, view, {Channel::distance, Effort::complete, true});
    distance = studio.renderer.read_light();
  }
  [[nodiscard]] Holes holes() const {
    return find_holes(distance, studio.renderer.pose(), view, solid_radius(studio.renderer.needs()));
  }
  float& at(int x, int y) { return distance[4 * static_cast<std::size_t>(y * view.width + x)]; }
};

TEST(Holes, AreNoneInThePlanet) {
  const Planet planet;
  EXPECT_EQ(planet.holes().open, 0);
  EXPECT_GT(planet.holes().looked_at, 100);
  EXPECT_LT(planet.holes().looked_at, 32 * 18);
}

TEST(Holes, AreSeenWhereAStarOrTheFarSideShowsThrough) {
  Planet planet;
  ASSERT_NEAR(planet.at(16, 9), 2.2F, 0.1F);
  planet.at(16, 9) = infinity;
  EXPECT_EQ(planet.holes().open, 1);
  planet.at(17, 9) = 4.2F;  // the inside of the far side
  EXPECT_EQ(planet.holes().open, 2);
  planet.at(18, 9) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(planet.holes().open, 3);
  planet.at(0, 0) = infinity;  // beside the planet, where there is sky
  EXPECT_EQ(planet.holes().open, 3);
}

TEST(Holes, AreNotLookedForWhereNothingIsSolid) {
  const Planet planet;
  EXPECT_EQ(find_holes(planet.distance, planet.studio.renderer.pose(), planet.view, 0.0).looked_at, 0);
}

Needs needs_of_a_bare_sea() {
  Needs needs;
  needs.water = Water::calm;
  needs.water_level = 4;
  return needs;
}

TEST(Cost, OfWhatTheNeedsDoNotCallForIsTold) {
  const View view;
  const Cost promised = promised_cost(needs_of_a_bare_sea(), view, 16);
  RenderStats work;
  work.programs = {"picture/tone", "water/calm"};
  work.triangles = 5000;
  work.draw_calls = 1;
  EXPECT_TRUE(beyond(work, promised).empty());
  work.programs.emplace_back("clouds/shell");
  work.triangles = 6000;  // of level 4 there are 5120
  work.draw_calls = 2;
  work.noise_evaluations = 1;
  work.textures = 6;
  work.gpu_bytes = 1'000'000'000;
  const std::vector<std::string> told = beyond(work, promised);
  ASSERT_EQ(told.size(), 6U);
  EXPECT_EQ(told[0], "triangles: 6000, but the needs promise at most 5120.");
  EXPECT_EQ(told[5], "program clouds/shell: nothing in the needs calls for it.");
}

}  // namespace
}  // namespace terrella
