// What the reference says of ice around a place is true of every place there, and narrow enough to be of use.
#include "reference/ice_bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "effort.hpp"
#include "laws/random_places.hpp"
#include "planet/terrain.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

using reference::ice_around;
using reference::Range;
using test::Places;

f64::Ice ice_from(double latitude, unsigned seed) {
  Scene scene = find_preset("blue")->scene;
  scene.water.ice_latitude = latitude;
  f64::Ice ice = exact_terrain_of(scene).ice;
  ice.seed = seed;
  return ice;
}

// A direction where there may be ice, but for half a bay on each side.
glm::dvec3 polar(Places& places, const f64::Ice& ice) {
  const double z = std::min(ice.sine + places.between(-0.06, 0.12), 1.0), angle = places.between(0.0, 6.28);
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

double height_at(const glm::dvec3& direction, const f64::Ice& ice, double footprint) {
  return f64::ice_height(f64::ice_cover(direction, ice, footprint), ice);
}

TEST(IceBounds, HoldAllIceAround) {
  Places places(31U);
  const int middles = test::sanitized ? 2'000 : 20'000;
  for (const double latitude : {50.0, 74.0, 86.0}) {
    for (const double footprint : {0.0, 0.025, 0.05}) {  // all floes, half of them, none
      for (int i = 0; i < middles; ++i) {
        const f64::Ice ice = ice_from(latitude, static_cast<unsigned>(i % 5));
        const glm::dvec3 middle = polar(places, ice);
        const double chord = std::pow(10.0, places.between(-7.0, -1.0));
        const Range range = ice_around(ice, middle, chord, footprint);
        for (int k = 0; k < 10; ++k) {
          const glm::dvec3 beside = glm::normalize(middle + 0.98 * chord * places.in_cube(0.577));
          const double height = height_at(beside, ice, footprint);
          ASSERT_GE(height, range.least - 1e-13) << latitude << ", chord " << chord;
          ASSERT_LE(height, range.most + 1e-13) << latitude << ", chord " << chord;
        }
      }
    }
  }
}

// Where the nearest point of all lies in a cell that only some places look in: for the others a further one is the
// nearest.
TEST(IceBounds, HoldWherePlacesLookInOtherCells) {
  struct Rare {
    unsigned seed;
    glm::dvec3 middle;  // cells
    double reach;       // cells
  };
  Places places(34U);
  for (const Rare& rare :
       {Rare{85U, {-1.00323, -5.97272, 13.72298}, 0.02074}, Rare{247U, {-3.9948, -6.1426, 13.0885}, 0.0052}}) {
    const f64::Ice ice = ice_from(50.0, rare.seed);
    const glm::dvec3 middle = glm::normalize(rare.middle);
    const double chord = rare.reach / f64::floe_frequency;
    const Range range = ice_around(ice, middle, chord, 0.0);
    for (int i = 0; i < 20'000; ++i) {
      const glm::dvec3 beside = glm::normalize(middle + 0.98 * chord * places.in_cube(0.577));
      const double height = height_at(beside, ice, 0.0);
      ASSERT_GE(height, range.least - 1e-13) << rare.seed;
      ASSERT_LE(height, range.most + 1e-13) << rare.seed;
    }
  }
}

TEST(IceBounds, OfOnePlaceAreItsHeight) {
  Places places(32U);
  for (int i = 0; i < 20'000; ++i) {
    const f64::Ice ice = ice_from(74.0, static_cast<unsigned>(i % 5));
    const glm::dvec3 place = polar(places, ice);
    const Range range = ice_around(ice, place, 0.0, 0.0);
    ASSERT_NEAR(range.least, height_at(place, ice, 0.0), 1e-13);
    ASSERT_NEAR(range.most, height_at(place, ice, 0.0), 1e-13);
  }
}

// Nearly every place within a piece of an Earth a hundred metres long either lies under the ice or has open water.
TEST(IceBounds, TellIceFromOpenWater) {
  Places places(33U);
  constexpr double chord = 100.0 / 6.36e6;
  int told = 0, open = 0;
  constexpr int count = 20'000;
  for (int i = 0; i < count; ++i) {
    const f64::Ice ice = ice_from(74.0, static_cast<unsigned>(i % 5));
    const Range range = ice_around(ice, polar(places, ice), chord, 0.0);
    const bool water = range.most < ice.sea;
    open += water ? 1 : 0;
    told += water || range.least > ice.sea ? 1 : 0;
  }
  EXPECT_GT(told, 0.98 * count);
  EXPECT_GT(open, count / 5);
  EXPECT_LT(open, told - count / 5);
}

}  // namespace
}  // namespace terrella
