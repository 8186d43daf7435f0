#include <gtest/gtest.h>

#include <algorithm>

#include "formulas/formulas.hpp"
#include "height_maps.hpp"
#include "laws/hills.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

using test::Places;

HeightTexels texels_of(const SharedHeightMap& map) { return {map.get(), map->serial()}; }

// Mostly anywhere, now and then near a pole or the date line.
glm::dvec3 somewhere(Places& places) {
  const double kind = places.between(0.0, 1.0), near = std::pow(10.0, places.between(-6.0, -1.0));
  glm::dvec3 d = places.on_sphere();
  if (kind < 0.2) d = {near * d.x, near * d.y, d.z < 0.0 ? -1.0 : 1.0};
  if (kind > 0.8) d = {-std::fabs(d.x), near * d.y, d.z};
  return glm::normalize(d);
}

double change_along(const glm::dvec3& d, const glm::dvec3& tangent, double step, const auto& height_at) {
  return (height_at(glm::normalize(d + step * tangent)) - height_at(glm::normalize(d - step * tangent))) / (2.0 * step);
}

TEST(SplineWeights, SumToOneAndChangeByTheirSteps) {
  const glm::dvec4 texels(0.3, -1.2, 2.0, 0.7);
  for (double t = 0.01; t < 1.0; t += 0.01) {
    EXPECT_NEAR(glm::dot(f64::spline_weights(t), glm::dvec4(1.0)), 1.0, 1e-15);
    const double change =
        (glm::dot(f64::spline_weights(t + 1e-6), texels) - glm::dot(f64::spline_weights(t - 1e-6), texels)) / 2e-6;
    EXPECT_NEAR(f64::spline_slope(f64::spline_steps(t), texels), change, 1e-8);
  }
}

// Row 0 in the north, column 0 at longitude -180 degrees, longitudes to the east.
TEST(HeightMap, IsTheFunctionThatItWasMadeFrom) {
  for (const auto& [width, height] : {std::pair(256, 128), std::pair(300, 101), std::pair(256, 256)}) {
    const SharedHeightMap map = test::smooth_map(width, height);
    Places places(1);
    for (int i = 0; i < 5000; ++i) {
      const glm::dvec3 d = somewhere(places);
      // The spline smooths by a sixth of the bend over a texel; at a pole two rows are of one height.
      const double allowed = std::fabs(d.z) > 0.99 ? 0.08 : 4.0 * map->texel() * map->texel() + 1e-3;
      ASSERT_NEAR(f64::map_height_at(texels_of(map), d, 1e-9).value, test::smooth_height(d), allowed)
          << d.x << " " << d.y << " " << d.z << " " << width;
    }
  }
}

TEST(HeightMap, GradientIsTheDerivativeEverywhere) {
  const SharedHeightMap map = test::rough_map(64, 30, 3);
  Places places(2);
  for (int i = 0; i < 20'000; ++i) {
    const glm::dvec3 d = somewhere(places);
    const double footprint = std::pow(10.0, places.between(-3.0, 0.5));
    const f64::MapHeight at = f64::map_height_at(texels_of(map), d, footprint);
    ASSERT_NEAR(glm::dot(at.gradient, d), 0.0, 1e-9);
    const glm::dvec3 u = f64::perpendicular(d), v = glm::cross(d, u);
    for (const glm::dvec3& tangent : {u, v}) {
      const double change = change_along(d, tangent, 1e-6, [&](const glm::dvec3& place) {
        return f64::map_height_at(texels_of(map), place, footprint).value;
      });
      ASSERT_NEAR(glm::dot(at.gradient, tangent), change, 2e-4) << d.x << " " << d.y << " " << d.z << " " << footprint;
    }
  }
}

TEST(HeightMap, HasNoSeamAndNoPole) {
  const SharedHeightMap map = test::rough_map(64, 30, 4);
  Places places(3);
  for (int i = 0; i < 1000; ++i) {
    const double z = places.between(-1.0, 1.0), r = std::sqrt(1.0 - z * z), turn = places.between(-3.1, 3.1);
    for (const double footprint : {0.01, 0.15, 0.4, 3.0}) {
      const auto at = [&](const glm::dvec3& d) { return f64::map_height_at(texels_of(map), d, footprint); };
      const f64::MapHeight west = at({-r, 1e-12, z}), east = at({-r, -1e-12, z});
      ASSERT_NEAR(west.value, east.value, 1e-9);
      ASSERT_LT(glm::distance(west.gradient, east.gradient), 1e-6);
      for (const double pole : {-1.0, 1.0}) {
        const f64::MapHeight here = at({0.0, 0.0, pole});
        const f64::MapHeight beside = at({1e-9 * std::cos(turn), 1e-9 * std::sin(turn), pole});
        ASSERT_NEAR(here.value, beside.value, 1e-9);
        ASSERT_LT(glm::distance(here.gradient, beside.gradient), 1e-6);
      }
    }
  }
}

TEST(HeightMap, StaysWithinItsRangeAndNoSteeperThanItSays) {
  for (const unsigned seed : {5U, 6U}) {
    const SharedHeightMap map = test::rough_map(64, seed == 5U ? 32 : 60, seed);
    Places places(seed);
    double steepest = 0.0;
    for (int i = 0; i < 50'000; ++i) {
      const f64::MapHeight at =
          f64::map_height_at(texels_of(map), somewhere(places), std::pow(10.0, places.between(-3.0, 0.5)));
      ASSERT_GE(at.value, double{map->lowest()} - 1e-12);
      ASSERT_LE(at.value, double{map->highest()} + 1e-12);
      steepest = std::max(steepest, glm::length(at.gradient));
    }
    EXPECT_LE(steepest, map->steepest());
    EXPECT_GE(steepest, 0.1 * map->steepest());  // else it would say nothing
  }
}

TEST(HeightMap, TendsToItsMeanAsSamplesMoveApart) {
  const SharedHeightMap map = test::rough_map(256, 128, 7);
  Places places(4);
  double before = 1.0;
  for (const double footprint : {0.01, 0.05, 0.1, 0.2, 0.4}) {
    double squares = 0.0;
    for (int i = 0; i < 4000; ++i) {
      const double off = f64::map_height_at(texels_of(map), places.on_sphere(), footprint).value - 0.5;
      squares += off * off / 4000.0;
    }
    EXPECT_LT(squares, before);
    before = 0.6 * squares;  // less of it by far at every step
  }
  EXPECT_EQ(map->unseen_variance(0.001), 0.0);
  EXPECT_GT(map->unseen_variance(0.1), map->unseen_variance(0.03));
}

// Ranges are asked for, which a map has of its own.
f64::Terrain hills_on(const SharedHeightMap& map) {
  f64::Terrain t = test::hills();
  t.ranges = {0.5, 1, 0.0};
  t.map = texels_of(map);
  return t;
}

TEST(MappedTerrain, IsTheMapWhereNoLayersAreAsked) {
  const SharedHeightMap map = test::smooth_map(128, 64);
  f64::Terrain t = hills_on(map);
  t.octaves = 0;
  Places places(8);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 d = places.on_sphere();
    EXPECT_DOUBLE_EQ(f64::terrain_height_at(d, t, 0.01).value, t.height * f64::map_height_at(t.map, d, 0.01).value);
  }
}

TEST(MappedTerrain, GradientIsTheDerivative) {
  const SharedHeightMap map = test::smooth_map(64, 32);
  for (const bool ridged : {false, true}) {
    for (const double power : {0.5, 1.0, 2.1, 6.0}) {
      f64::Terrain t = hills_on(map);
      t.ridged = ridged;
      t.power = power;
      Places places(9);
      for (int i = 0; i < 500; ++i) {
        const glm::dvec3 d = somewhere(places), u = f64::perpendicular(d);
        const f64::Height at = f64::terrain_height_at(d, t, 0.003);
        const double change = change_along(
            d, u, 3e-8, [&](const glm::dvec3& place) { return f64::terrain_height_at(place, t, 0.003).value; });
        ASSERT_NEAR(glm::dot(at.gradient, u), change, 2e-5) << power;  // sharp ridges bend within little more
      }
    }
  }
}

// On a map of one height everywhere what is left are the layers that its texels can't hold, as strong as ever.
TEST(MappedTerrain, AddsTheLayersThatAreFinerThanTexels) {
  const SharedHeightMap map = std::make_shared<const HeightMap>(64, 32, std::vector<float>(std::size_t{64 * 32}, 0.5F));
  const f64::Terrain t = hills_on(map);
  const int first = f64::first_layer_beyond(map->texel(), t);
  ASSERT_EQ(first, 2);  // cells of 1/1.3 and 1/2.64 rad are wider than three texels of 0.098, of 1/5.36 are not
  Places places(10);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 d = places.on_sphere();
    double sum = 0.0, amplitude = 1.0, frequency = t.frequency;
    for (int layer = 0; layer < t.octaves; ++layer) {
      const f64::Noise n = f64::simplex_noise(glm::ivec3(0), d * frequency + f64::layer_offset(layer, t.seed),
                                              f64::layer_seed(layer, t.seed));
      if (layer >= first) sum += amplitude * 0.5 * n.value;
      amplitude *= t.persistence;
      frequency *= t.lacunarity;
    }
    const double mean = sum / f64::amplitude_sum(t.persistence, t.octaves);
    // Where layers alone reach half of the height, a unit of their mean adds so much.
    const double rise = f64::height_power_slope(std::pow(0.5, 1.0 / t.power), t.height, t.power);
    EXPECT_NEAR(f64::terrain_height_at(d, t, 1e-6).value, 0.5 * t.height + rise * mean, 0.03 * rise * std::fabs(mean));
  }
}

}  // namespace
}  // namespace terrella
