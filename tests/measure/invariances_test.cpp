#include "measure/invariances.hpp"

#include <gtest/gtest.h>

#include "measure/extent.hpp"
#include "measure/studio.hpp"
#include "measure/trials.hpp"

namespace terrella {
namespace {

TEST(Invariances, Hold) {
  test::Studio studio;
  for (const Invariance& found : measure_invariances(studio.renderer, test::extent)) {
    EXPECT_TRUE(found.tells()) << found.what << ": nothing in it could differ";
    EXPECT_TRUE(found.holds()) << found.what << ": " << found.error << ' ' << found.measured << " > " << found.bound;
  }
}

TEST(Invariances, TellNothingOfStillPictures) {
  test::Studio studio;
  Scene still = cheap("temperate");
  still.clouds.speed = still.clouds.drift = still.water.ripple_speed = 0.0;
  const Invariance found = moves_alike(studio.renderer, "a still planet", still, Channel::color, 1.3);
  EXPECT_EQ(found.at_stake, 0.0);
  EXPECT_FALSE(found.holds());
}

TEST(Contrast, IsNoneInEmptyPicturesWhateverTheirColour) {
  std::vector<float> pixels(400, 0.0F);
  for (std::size_t i = 3; i < pixels.size(); i += 4) pixels[i] = 1.0F;  // opaque
  EXPECT_EQ(contrast_of(pixels), 0.0);
  for (std::size_t i = 0; i < pixels.size() / 2; i += 4) pixels[i] = 1.0F;
  EXPECT_NEAR(contrast_of(pixels), 0.25, 1e-12);  // half of the pixels differ in one of four channels
}

}  // namespace
}  // namespace terrella
