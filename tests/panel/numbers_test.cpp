// Sliders' ranges and numbers with their units.
#include <gtest/gtest.h>

#include <cmath>

#include "panel/quantity.hpp"
#include "panel/slider_range.hpp"

namespace terrella {
namespace {

bool is_number(const Parameter& parameter) { return parameter.type == Type::Float || parameter.type == Type::Int; }

double default_of(const Parameter& parameter) {
  const auto* whole = std::get_if<int>(&parameter.default_value);
  return whole != nullptr ? *whole : std::get<double>(parameter.default_value);
}

Scene planet_of(double radius) {
  Scene scene;
  scene.planet.radius = radius;
  return scene;
}

TEST(SliderRange, RisesFromEndToEndWithinWhatIsAllowed) {
  for (const double radius : {1.0, 37.0, 6371000.0, 1e8}) {
    const Scene scene = planet_of(radius);
    for (const Parameter& parameter : parameters()) {
      if (!is_number(parameter)) continue;
      const SliderRange range = slider_range(parameter, scene);
      ASSERT_LT(range.low, range.high) << parameter.path;
      ASSERT_EQ(range.value_at(0.0), range.low);
      ASSERT_EQ(range.value_at(1.0), range.high);
      double before = range.low;
      for (int i = 1; i <= 500; ++i) {
        const double value = range.value_at(i / 500.0);
        ASSERT_GE(value, before) << parameter.path << " at " << i;
        ASSERT_LE(value, parameter.max);
        before = value;
      }
    }
  }
}

TEST(SliderRange, ShowsAValueWhereItWasSet) {
  for (const Parameter& parameter : parameters()) {
    if (!is_number(parameter)) continue;
    const SliderRange range = slider_range(parameter, Scene{});
    const double step = range.whole ? 1.0 / (range.high - range.low) : 0.0;  // its values lie far apart
    for (int i = 0; i <= 100; ++i) {
      EXPECT_NEAR(range.position_of(range.value_at(i / 100.0)), i / 100.0, 0.004 + step) << parameter.path;
    }
  }
}

TEST(SliderRange, HoldsEveryDefault) {
  for (const Parameter& parameter : parameters()) {
    if (!is_number(parameter)) continue;
    const SliderRange range = slider_range(parameter, Scene{});
    const double value = default_of(parameter);
    EXPECT_LE(value, range.high) << parameter.path;
    const double fineness = range.first > 0.0 ? 0.005 * value : (range.high - range.low) / 500.0;
    EXPECT_NEAR(range.value_at(range.position_of(value)), value, fineness) << parameter.path;
  }
}

TEST(SliderRange, TellsRoundNumbers) {
  const SliderRange range{0.0, 1.0};
  EXPECT_EQ(range.value_at(0.29973), 0.3);
  EXPECT_EQ(range.value_at(1.0 / 3.0), 0.333);
  EXPECT_EQ(range.position_of(NAN), 0.0);
  EXPECT_EQ(range.position_of(7.0), 1.0);
}

TEST(Quantity, FitsItsUnitToTheMagnitude) {
  const Parameter& height = *find_parameter("terrain.height");
  EXPECT_EQ(quantity_text(height, 0.0), "0 m");
  EXPECT_EQ(quantity_text(height, 0.0425), "42.5 mm");
  EXPECT_EQ(quantity_text(height, 3e-6), "3 \u00b5m");
  EXPECT_EQ(quantity_text(height, 8848.0), "8.848 km");
  EXPECT_EQ(quantity_text(height, 1e8), "100000 km");
  EXPECT_EQ(quantity_text(*find_parameter("waves.speed"), 0.05), "50 mm/s");
  EXPECT_EQ(quantity_text(*find_parameter("camera.pitch"), -90.0), "-90\u00b0");
  EXPECT_EQ(quantity_text(*find_parameter("waves.steepness"), 0.6), "0.6");
}

TEST(Quantity, ReadsBackWhatIsShownToBeEdited) {
  for (const Parameter& parameter : parameters()) {
    if (!is_number(parameter)) continue;
    for (const double value : {parameter.min, default_of(parameter), parameter.max}) {
      const auto read = read_quantity(quantity_to_edit(parameter, value), parameter, value);
      ASSERT_TRUE(read) << parameter.path;
      EXPECT_NEAR(*read, value, 1e-11 * std::abs(value)) << parameter.path;
    }
  }
}

TEST(Quantity, ReadsUnitsThatBeginWithADigit) {
  const Parameter& absorption = *find_parameter("water.absorption_red");
  EXPECT_EQ(read_quantity("0.5 1/m", absorption, 1.0), 0.5);
  EXPECT_EQ(read_quantity("0.1/m", absorption, 1.0), 0.1);
  EXPECT_EQ(read_quantity("21", absorption, 1.0), 21.0);
}

TEST(Quantity, ReadsUnitsAndHoldsTheRange) {
  const Parameter& radius = *find_parameter("planet.radius");
  EXPECT_EQ(read_quantity(" 6371 km ", radius, 1.0), 6371000.0);
  EXPECT_EQ(read_quantity("6371km", radius, 1.0), 6371000.0);
  EXPECT_EQ(read_quantity("120 cm", radius, 1.0), 1.2);
  EXPECT_EQ(read_quantity("5", radius, 8000.0), 5000.0);  // shown in kilometres
  EXPECT_EQ(read_quantity("1 mm", radius, 1.0), 1.0);
  EXPECT_EQ(read_quantity("1e999", radius, 1.0), 1e8);
  EXPECT_EQ(read_quantity("", radius, 1.0), std::nullopt);
  EXPECT_EQ(read_quantity("km", radius, 1.0), std::nullopt);
  EXPECT_EQ(read_quantity("1 2 km", radius, 1.0), std::nullopt);
}

}  // namespace
}  // namespace terrella
