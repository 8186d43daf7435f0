#include <gtest/gtest.h>

#include <vector>

#include "formulas/formulas.hpp"
#include "laws/hills.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

using test::hills;
using test::Places;

TEST(SmoothAbs, LiesBelowTheMagnitudeByNoMoreThanItsBound) {
  for (const double k : {0.1, 1.0, 14.0, 1000.0}) {
    for (double x = -3.0; x <= 3.0; x += 0.001) {
      const double y = f64::smooth_abs(x, k);
      ASSERT_LE(y, std::fabs(x));
      ASSERT_GE(y, std::fabs(x) - 0.27847 / k);  // the largest difference of x tanh(kx) from |x|
      ASSERT_DOUBLE_EQ(y, f64::smooth_abs(-x, k));
    }
  }
  EXPECT_EQ(f64::smooth_abs(2.0, 0.0), 0.0);
  EXPECT_EQ(f64::smooth_abs(1e6, 1e6), 1e6);  // the printed form overflows here
}

TEST(SmoothAbs, IsXTimesTanh) {
  for (double x = -2.0; x <= 2.0; x += 0.01) EXPECT_NEAR(f64::smooth_abs(x, 5.0), x * std::tanh(5.0 * x), 1e-15);
}

TEST(SmoothAbs, SlopeIsTheDerivative) {
  for (const double k : {0.5, 14.0, 200.0}) {
    for (double x = -1.5; x <= 1.5; x += 0.0037) {
      const double h = 1e-6 / k;
      const double change = (f64::smooth_abs(x + h, k) - f64::smooth_abs(x - h, k)) / (2.0 * h);
      ASSERT_NEAR(f64::smooth_abs_slope(x, k), change, 1e-6) << x << " " << k;
    }
  }
}

TEST(HeightPower, KeepsItsEnds) {
  for (const double p : {0.5, 1.0, 2.1, 16.0}) {
    EXPECT_EQ(f64::height_power(0.0, 0.2, p), 0.0);
    EXPECT_EQ(f64::height_power(-0.01, 0.2, p), 0.0);
    EXPECT_DOUBLE_EQ(f64::height_power(1.0, 0.2, p), 0.2);
    EXPECT_DOUBLE_EQ(f64::height_power(1.01, 0.2, p), 0.2);
  }
  EXPECT_EQ(f64::height_power(0.0, 0.2, 0.0), 0.2);  // 0^0 is 1
}

TEST(HeightPower, RisesAndItsSlopeIsTheDerivative) {
  for (const double p : {0.5, 1.0, 2.1, 7.0}) {
    double before = -1.0;
    for (double h = 0.01; h < 0.99; h += 0.01) {
      const double y = f64::height_power(h, 0.2, p);
      EXPECT_GT(y, before);
      before = y;
      const double change = (f64::height_power(h + 1e-6, 0.2, p) - f64::height_power(h - 1e-6, 0.2, p)) / 2e-6;
      EXPECT_NEAR(f64::height_power_slope(h, 0.2, p), change, 1e-6 * (1.0 + change));
    }
  }
}

TEST(LayerWeight, ShowsAllOfWhatHasFourSamplesACellAndNothingUnderTwo) {
  EXPECT_EQ(f64::layer_weight(10.0, 0.025), 1.0);
  EXPECT_EQ(f64::layer_weight(10.0, 0.05), 0.0);
  EXPECT_EQ(f64::layer_weight(1e9, 1.0), 0.0);
  EXPECT_EQ(f64::layer_weight(1e9, 0.0), 1.0);
}

// Hills, ridges, and both with ranges.
std::vector<f64::Terrain> kinds() {
  std::vector<f64::Terrain> all;
  for (const double ranges : {0.0, 0.4, 1.0}) {
    for (const bool ridged : {false, true}) {
      f64::Terrain t = hills();
      t.ridged = ridged;
      t.craters.depth = ridged ? 0.0 : 1.0;
      t.ranges = {ranges, 2, 0.2};
      all.push_back(t);
    }
  }
  return all;
}

TEST(TerrainHeight, StaysBetweenTheSphereAndItsHighest) {
  Places places(21U);
  for (const f64::Terrain& t : kinds()) {
    for (int i = 0; i < 20'000; ++i) {
      const double h = f64::terrain_height_at(places.on_sphere(), t, 0.0).value;
      ASSERT_GE(h, 0.0);
      ASSERT_LE(h, t.height);
    }
  }
}

TEST(TerrainHeight, GradientIsTheDerivativeAlongTheSphere) {
  Places places(22U);
  for (const f64::Terrain& t : kinds()) {
    for (int i = 0; i < 5000; ++i) {
      const glm::dvec3 d = places.on_sphere();
      const f64::Height ground = f64::terrain_height_at(d, t, 0.002);
      if (ground.value < 1e-4) continue;  // the slope is held finite at 0
      const glm::dvec3 side = glm::normalize(glm::cross(d, places.on_sphere()));
      const double h = 3e-8;  // sharp ridges bend within little more
      const double change = f64::terrain_height_at(glm::normalize(d + h * side), t, 0.002).value -
                            f64::terrain_height_at(glm::normalize(d - h * side), t, 0.002).value;
      ASSERT_NEAR(glm::dot(ground.gradient, side), change / (2.0 * h), 2e-5) << t.ridged << " " << t.ranges.part;
    }
  }
}

TEST(TerrainHeight, RangesStandOnHighGroundOnly) {
  Places places(28U);
  f64::Terrain with = hills(), without = hills();
  with.ranges = {0.5, 2, 0.0};
  int low = 0, high = 0;
  for (int i = 0; i < 5000; ++i) {
    const glm::dvec3 d = places.on_sphere();
    const double smooth = f64::terrain_height_at(d, without, 0.0).value;
    const double raised = f64::terrain_height_at(d, with, 0.0).value - 0.5 * smooth;
    // The mean of all layers from the height that its power has given.
    const double mean = std::pow(smooth / without.height, 1.0 / without.power);
    if (mean < 0.499) {
      ++low;
      ASSERT_NEAR(raised, 0.0, 1e-12);
    } else if (mean > 0.6 && raised > 0.02 * with.height) {
      ++high;
    }
  }
  EXPECT_GT(low, 1000);
  EXPECT_GT(high, 300);
}

// On low ground the ranges are so much of what they are on high ground, and no more there.
TEST(Relief, HasFoothillsOnLowGround) {
  f64::Terrain with = hills(), without = hills();
  with.ranges = {0.5, 2, 0.1};
  without.ranges = {0.5, 2, 0.0};
  for (const double ridges : {0.1, 0.5, 0.9}) {
    const double whole = 0.5 * with.height * ridges * ridges * ridges;
    for (const double mean : {0.1, 0.3, 0.499}) {
      const double smooth = f64::relief_of(without, mean, ridges).value;
      EXPECT_NEAR(f64::relief_of(with, mean, ridges).value, smooth + 0.1 * whole, 1e-15);
    }
    EXPECT_EQ(f64::relief_of(with, 0.8, ridges).value, f64::relief_of(without, 0.8, ridges).value);
  }
}

// Pixels go on with the means where vertices left off: to what vertices so near to each other would hold.
TEST(TerrainHeight, IsThatOfItsMeansWhateverElseIsAddedToThem) {
  Places places(29U);
  for (const f64::Terrain& t : kinds()) {
    for (int i = 0; i < 500; ++i) {
      const glm::dvec3 d = places.on_sphere();
      for (const double footprint : {0.0, 0.01, 0.1}) {
        const f64::Height ground = f64::terrain_height_at(d, t, footprint);
        if (!ground.iced) {
          EXPECT_EQ(ground.value, f64::relief_of(t, ground.mean, ground.shape).value);
        }
      }
    }
  }
}

TEST(Relief, TellsHowItChangesWithEachMean) {
  for (const f64::Terrain& t : kinds()) {
    for (double mean = 0.02; mean < 0.98; mean += 0.017) {
      for (double ridges = 0.05; ridges < 1.0; ridges += 0.05) {
        const double step = 1e-6;
        const auto height = [&](double more_mean, double more_ridges) {
          return f64::relief_of(t, mean + more_mean, ridges + more_ridges).value;
        };
        const f64::Relief here = f64::relief_of(t, mean, ridges);
        EXPECT_NEAR(here.by_mean, (height(step, 0.0) - height(-step, 0.0)) / (2.0 * step), 1e-4 * t.height);
        EXPECT_NEAR(here.by_shape, (height(0.0, step) - height(0.0, -step)) / (2.0 * step), 1e-4 * t.height);
      }
    }
  }
}

TEST(Openness, RisesFromNoneToAllThroughAHalf) {
  EXPECT_EQ(f64::openness_of(0.0), 0.5);
  double before = 0.0;
  for (double relief = -3.0; relief < 3.0; relief += 0.01) {
    const double openness = f64::openness_of(relief);
    ASSERT_GT(openness, before);
    ASSERT_LT(openness, 1.0);
    ASSERT_NEAR(openness + f64::openness_of(-relief), 1.0, 1e-12);
    before = openness;
  }
}

// What is called a hollow lies below the mean of what is around it.
TEST(Openness, IsLowInHollowsAndHighOnCrests) {
  Places places(26U);
  const f64::Terrain t = hills();
  double low = 0.0, high = 0.0;
  int lows = 0, highs = 0;
  for (int i = 0; i < 20'000; ++i) {
    const glm::dvec3 d = places.on_sphere();
    const f64::Height here = f64::terrain_height_at(d, t, 0.002);
    const glm::dvec3 east = glm::normalize(glm::cross(d, places.on_sphere())), north = glm::cross(d, east);
    double around = 0.0;
    for (const glm::dvec3& side : {east, -east, north, -north}) {
      around += 0.25 * f64::terrain_height_at(glm::normalize(d + 0.03 * side), t, 0.002).value;
    }
    const double above = here.value - around;
    if (above < -0.002) low += here.openness, ++lows;
    if (above > 0.002) high += here.openness, ++highs;
  }
  ASSERT_GT(std::min(lows, highs), 200);
  EXPECT_LT(low / lows, 0.33);    // measured 0.309
  EXPECT_GT(high / highs, 0.71);  // measured 0.737
}

TEST(TerrainHeight, WithoutOctavesOrHeightIsTheSphere) {
  f64::Terrain t = hills();
  t.octaves = 0;
  EXPECT_EQ(f64::terrain_height_at(glm::dvec3(1.0, 0.0, 0.0), t, 0.0).value, 0.0);
  t = hills();
  t.height = 0.0;
  EXPECT_EQ(f64::terrain_height_at(glm::dvec3(0.0, 1.0, 0.0), t, 0.0).value, 0.0);
}

TEST(TerrainHeight, FadesToItsMeanAsSamplesGrowCoarse) {
  f64::Terrain t = hills();
  t.power = 1.0;
  Places places(23U);
  for (int i = 0; i < 100; ++i) {
    const f64::Height h = f64::terrain_height_at(places.on_sphere(), t, 10.0);
    EXPECT_NEAR(h.value, 0.5 * t.height, 1e-12);
    EXPECT_EQ(glm::length(h.gradient), 0.0);
  }
}

TEST(TerrainHeight, IsFiniteAtTheEndsOfEveryParameter) {
  Places places(24U);
  f64::Terrain t = hills();
  for (const double persistence : {0.0, 1.0, 1.5})
    for (const double lacunarity : {1.0, 4.0})
      for (const double power : {0.0, 0.01, 16.0})
        for (const double sharpness : {0.0, 1000.0})
          for (const int octaves : {1, 24}) {
            t.persistence = persistence;
            t.lacunarity = lacunarity;
            t.power = power;
            t.sharpness = sharpness;
            t.octaves = octaves;
            t.ridged = octaves == 24;
            const f64::Height h = f64::terrain_height_at(places.on_sphere(), t, 1e-3);
            ASSERT_TRUE(std::isfinite(h.value) && std::isfinite(glm::length(h.gradient)));
          }
}

template <class Terrain>
Terrain with_faint_ranges(double persistence) {
  Terrain t{};
  t.height = 0.01F;
  t.frequency = 3.0F;
  t.octaves = 20;
  t.persistence = static_cast<decltype(t.persistence)>(persistence);
  t.lacunarity = 2.0F;
  t.power = 1.0F;
  t.sharpness = 8.0F;
  t.ranges = {0.5F, 16, 0.0F};
  return t;
}

// Of layers that fade so fast that those of the ridges are nothing to single precision, or that what is divided by them
// is more than it holds.
TEST(TerrainHeight, IsFiniteWithRangesOfTheFaintestLayers) {
  Places places(25U);
  for (const double persistence : {1e-3, 2e-3, 2.5e-3, 3e-3, 1e-2}) {
    const auto t = with_faint_ranges<f32::Terrain>(persistence);
    for (int i = 0; i < 50; ++i) {
      const f32::Height h = f32::terrain_height_at(glm::vec3(places.on_sphere()), t, 1e-4F);
      ASSERT_TRUE(std::isfinite(h.value) && std::isfinite(glm::length(h.gradient))) << persistence;
    }
  }
}

TEST(Openness, OfTheSteepestRangesIsAllOrNothing) {
  Places places(26U);
  int on_ranges = 0;
  for (int i = 0; i < 50; ++i) {
    const glm::dvec3 place = places.on_sphere();
    const double exact = f64::terrain_height_at(place, with_faint_ranges<f64::Terrain>(0.02), 1e-4).openness;
    if (std::abs(exact - 0.5) < 0.499) continue;
    ++on_ranges;
    const auto t = with_faint_ranges<f32::Terrain>(0.02);
    EXPECT_NEAR(f32::terrain_height_at(glm::vec3(place), t, 1e-4F).openness, exact, 1e-3);
  }
  EXPECT_GT(on_ranges, 10);
}

TEST(SurfaceNormal, IsThatOfTheDisplacedSurface) {
  Places places(25U);
  const f64::Terrain t = hills();
  const auto point = [&](const glm::dvec3& d) { return d * (1.0 + f64::terrain_height_at(d, t, 0.002).value); };
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 d = places.on_sphere();
    const f64::Height ground = f64::terrain_height_at(d, t, 0.002);
    if (ground.value < 1e-4) continue;
    const glm::dvec3 east = glm::normalize(glm::cross(d, places.on_sphere())), north = glm::cross(d, east);
    const double h = 1e-6;
    const glm::dvec3 a = point(glm::normalize(d + h * east)) - point(glm::normalize(d - h * east));
    const glm::dvec3 b = point(glm::normalize(d + h * north)) - point(glm::normalize(d - h * north));
    const glm::dvec3 expected = glm::normalize(glm::cross(a, b));
    ASSERT_LT(glm::distance(f64::surface_normal(d, 1.0 + ground.value, ground.gradient), expected), 1e-4);
  }
}

TEST(HeightPower, SlopeIsKnownFromTheHeightThatItHasGiven) {
  for (const double p : {0.5, 1.0, 2.1, 4.0}) {
    for (double h = 0.05; h < 0.99; h += 0.01) {
      const double slope = f64::height_power_slope(h, 0.2, p);
      EXPECT_NEAR(f64::height_power_slope_at(f64::height_power(h, 0.2, p), 0.2, p), slope, 1e-9 * (1.0 + slope));
    }
  }
  for (const double value : {-0.1, 0.0, 0.2, 0.3}) {
    EXPECT_TRUE(std::isfinite(f64::height_power_slope_at(value, 0.2, 0.0)));
    EXPECT_TRUE(std::isfinite(f64::height_power_slope_at(value, 0.0, 2.0)));
  }
}

TEST(Layer, SlopeIsTheDerivativeAndItsMeanIsWhatItLeavesBehind) {
  Places places(27U);
  for (const bool ridged : {false, true}) {
    double sum = 0.0;
    const int count = 100'000;
    for (int i = 0; i < count; ++i) {
      const double n = f64::simplex_noise(glm::ivec3(0), places.in_cube(100.0), 5U).value;
      sum += f64::layer_value(n, ridged, 1000.0);
      const double change =
          (f64::layer_value(n + 1e-6, ridged, 14.0) - f64::layer_value(n - 1e-6, ridged, 14.0)) / 2e-6;
      ASSERT_NEAR(f64::layer_slope(n, ridged, 14.0), change, 1e-6);
    }
    EXPECT_NEAR(sum / count, f64::layer_mean(ridged), 0.01);
  }
  EXPECT_EQ(f64::layer_value(1.0, false, 14.0), 1.0);
  EXPECT_EQ(f64::layer_value(-1.0, false, 14.0), 0.0);
  EXPECT_EQ(f64::layer_value(0.0, true, 14.0), 1.0);
}

TEST(Layer, IsAsSteepInTheMeanAsItsNoiseTells) {
  Places places(29U);
  constexpr int count = 100'000;
  std::vector<f64::Noise> noises;
  double noise_square = 0.0;
  for (int i = 0; i < count; ++i) {
    noises.push_back(f64::simplex_noise(glm::ivec3(0), places.in_cube(100.0), 5U));
    noise_square += glm::dot(noises.back().gradient, noises.back().gradient) / (3.0 * count);
  }
  EXPECT_NEAR(noise_square, f64::noise_slope_square, 0.02);
  const auto measured = [&](bool ridged, double sharpness) {
    double sum = 0.0;
    for (const f64::Noise& n : noises) {
      const glm::dvec3 slope = f64::layer_slope(n.value, ridged, sharpness) * n.gradient;
      sum += glm::dot(slope, slope) / (3.0 * count);
    }
    return sum / noise_square;
  };
  EXPECT_DOUBLE_EQ(measured(false, 14.0), f64::layer_slope_square(false, 14.0));
  for (const double k : {0.5, 1.0, 2.0, 4.0, 8.0, 14.0, 30.0, 1000.0}) {
    const double told = f64::layer_slope_square(true, k);
    EXPECT_GT(measured(true, k), 0.95 * told) << k;
    EXPECT_LT(measured(true, k), 1.1 * told) << k;
  }
  EXPECT_NEAR(f64::layer_slope_square(true, 0.0), 0.0, 1e-6);
}

TEST(SlopeNormal, IsAtRightAnglesToTheSurface) {
  Places places(28U);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 d = places.on_sphere(), east = f64::perpendicular(d), north = glm::cross(d, east);
    const double radius = places.between(0.5, 2.0), a = places.between(-2.0, 2.0), b = places.between(-2.0, 2.0);
    const glm::dvec3 n = f64::slope_normal(d, radius, a * east + b * north);
    ASSERT_NEAR(glm::length(n), 1.0, 1e-12);
    ASSERT_GT(glm::dot(n, d), 0.0);
    ASSERT_NEAR(glm::dot(n, radius * east + a * d), 0.0, 1e-12);
    ASSERT_NEAR(glm::dot(n, radius * north + b * d), 0.0, 1e-12);
  }
}

}  // namespace
}  // namespace terrella
