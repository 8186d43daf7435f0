#include "planet/water_medium.hpp"

#include <gtest/gtest.h>

#include "planet/materials.hpp"
#include "scene/choices.hpp"

namespace terrella {
namespace {

Scene water_of(int medium) {
  Scene scene;
  scene.planet.radius = 6.36e6;
  scene.water.medium = medium;
  return scene;
}

TEST(WaterMedium, IsNoneOfTintedWater) {
  const Scene scene = water_of(choice("water.medium", "tinted"));
  EXPECT_FALSE(medium_of(scene));
  EXPECT_EQ(water_look_of(scene).clarity, scene.water.clarity / scene.planet.radius);
}

TEST(WaterMedium, AsMeasuredIsWhatTheSceneSays) {
  Scene scene = water_of(choice("water.medium", "measured"));
  scene.water.absorption_red = 0.4;
  scene.water.absorption_green = 0.2;
  scene.water.absorption_blue = 0.1;
  scene.water.scattering = 0.05;
  const auto medium = medium_of(scene);
  ASSERT_TRUE(medium);
  EXPECT_EQ(medium->absorption, glm::dvec3(0.4, 0.2, 0.1));
  EXPECT_NEAR(medium->backscattering.r, 0.0451, 1e-4);
  EXPECT_EQ(medium->backscattering.g, 0.05);
  EXPECT_NEAR(medium->backscattering.b, 0.0591, 1e-4);
  const f64::WaterLook look = water_look_of(scene);
  EXPECT_NEAR(look.extinction.g, 0.25 * scene.planet.radius, 1e-6);
  EXPECT_NEAR(look.color.g, 0.33 * 0.2, 1e-12);  // a fifth of what is lost is scattered back
}

TEST(WaterMedium, OfTheClearOceanIsBlueAndTheClearest) {
  const auto ocean = medium_of(water_of(choice("water.medium", "clear_ocean")));
  ASSERT_TRUE(ocean);
  const glm::dvec3 color = color_of_depths(*ocean);
  EXPECT_GT(color.b, 2.0 * color.g);
  EXPECT_GT(color.g, 2.0 * color.r);
  for (const int other :
       {choice("water.medium", "coastal"), choice("water.medium", "lagoon"), choice("water.medium", "alien")}) {
    const auto medium = medium_of(water_of(other));
    ASSERT_TRUE(medium);
    EXPECT_GT(extinction_of(*medium).g, extinction_of(*ocean).g);
    EXPECT_GT(extinction_of(*medium).b, extinction_of(*ocean).b);
    for (int i = 0; i < 3; ++i) {
      EXPECT_GT(color_of_depths(*medium)[i], 0.0);
      EXPECT_LT(color_of_depths(*medium)[i], 0.33);
    }
  }
}

}  // namespace
}  // namespace terrella
