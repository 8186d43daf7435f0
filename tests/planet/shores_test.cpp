#include "planet/shores.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/presets.hpp"

namespace terrella {
namespace {

Scene preset(const char* name) { return find_preset(name)->scene; }

// Medians of three hundred shores: 0.028, 0.32 and 0.040, without what is finer than 20 m.
TEST(Shores, AreAsSteepAsMostShoresOfThePlanet) {
  const double footprint = 20.0 / 6.36e6;
  EXPECT_NEAR(shore_slope(preset("blue"), footprint), 0.028, 0.014);
  EXPECT_NEAR(shore_slope(preset("atolls"), footprint), 0.32, 0.16);
  EXPECT_NEAR(shore_slope(preset("isles"), footprint), 0.040, 0.02);
}

TEST(Shores, HaveASlopeWhereThereAreNone) {
  Scene scene = preset("blue");
  const double footprint = 1e-5, slope = shore_slope(scene, footprint);
  scene.water.level = 12'000.0;
  EXPECT_EQ(shore_slope(scene, footprint), 0.05);
  scene.water.level = 1000.0;
  EXPECT_EQ(shore_slope(scene, footprint), slope);
}

TEST(Shores, AreWetWhereWavesRunUp) {
  Scene scene = preset("blue");
  const Sea sea = make_sea(scene, 0.0);
  EXPECT_GT(wet_height(scene, sea) * scene.planet.radius, 0.05);
  EXPECT_LT(wet_height(scene, sea) * scene.planet.radius, 1.0);
  scene.waves.count = 0;
  EXPECT_EQ(wet_height(scene, make_sea(scene, 0.0)), 0.0);
}

// Layers about as small as waves are high; none where the ground ends before.
TEST(Shores, TearFoamByTheNoiseOfTheGround) {
  Scene scene = preset("blue");
  const Sea sea = make_sea(scene, 0.0);
  const int layer = foam_layer(scene, sea);
  ASSERT_GT(layer, 0);
  const double frequency = scene.terrain.frequency * std::pow(scene.terrain.lacunarity, layer);
  EXPECT_GT(frequency * whole_wave_depth(sea), 3.0);
  EXPECT_LE(frequency * whole_wave_depth(sea), 6.0 + 0.1);
  scene.terrain.octaves = layer;
  EXPECT_EQ(foam_layer(scene, sea), -1);
}

}  // namespace
}  // namespace terrella
