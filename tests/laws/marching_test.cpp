#include <gtest/gtest.h>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"
#include "laws/rounding.hpp"

namespace terrella {
namespace {

using test::Places;
using test::roundoff;

TEST(MeanTransmittance, TimesTheDepthIsWhatIsAbsorbed) {
  for (double x = 1e-12; x < 700.0; x *= 1.01) {
    ASSERT_NEAR(f64::mean_transmittance(x) * x, -std::expm1(-x), -1e-15 * std::expm1(-x));
    ASSERT_NEAR(f64::absorbed_share(x), -std::expm1(-x), -1e-15 * std::expm1(-x));
    // Of a medium that gives light instead: (e^x - 1) / x.
    if (x < 100.0) {
      ASSERT_NEAR(f64::mean_transmittance(-x) * x, std::expm1(x), 1e-14 * std::expm1(x));
    }
    const float y = static_cast<float>(x);
    const double absorbed = -std::expm1(-double{y});
    ASSERT_NEAR(f32::absorbed_share(y), absorbed, 8.0 * roundoff * absorbed);
    ASSERT_NEAR(f32::mean_transmittance(y), absorbed / double{y}, 8.0 * roundoff * absorbed / double{y});
  }
  EXPECT_EQ(f64::mean_transmittance(0.0), 1.0);
  EXPECT_EQ(f32::mean_transmittance(0.0F), 1.0F);
  EXPECT_EQ(f64::absorbed_share(0.0), 0.0);
}

TEST(MarchCloud, OfAnEvenCloudDoesNotDependOnTheStep) {
  const double density = 0.6, length = 900.0, extinction = 4e-3, scattering = 3e-3, light = 0.7;
  const double depth = extinction * density * length;
  for (const int steps : {1, 2, 7, 100}) {
    f64::Marched m = f64::not_marched();
    for (int i = 0; i < steps; ++i) f64::march_cloud(m, density, length / steps, extinction, scattering, light);
    EXPECT_NEAR(m.transmittance, std::exp(-depth), 1e-14);
    EXPECT_NEAR(m.light, scattering / extinction * light * (1.0 - std::exp(-depth)), 1e-14);
  }
}

TEST(MarchCloud, NothingIsInFrontOfNothing) {
  f64::Marched m = f64::not_marched();
  EXPECT_EQ(m.transmittance, 1.0);
  EXPECT_EQ(m.light, 0.0);
  for (int i = 0; i < 20; ++i) f64::march_cloud(m, -1.0, 100.0, 4e-3, 3e-3, 1.0);
  EXPECT_EQ(m.transmittance, 1.0);  // the print has 2981 here
  EXPECT_EQ(m.light, 0.0);
}

TEST(MarchSegment, KeepsTheLightSoFarAndDimsWhatIsBehind) {
  f64::Marched m = f64::not_marched();
  f64::march_segment(m, 0.9, 0.1, 0.5, 0.3);
  EXPECT_NEAR(m.transmittance, 0.45, 1e-15);
  EXPECT_NEAR(m.light, 0.1 * 0.5 + 0.3, 1e-15);
  f64::march_segment(m, 0.8, 0.2, 0.7, 0.4);
  EXPECT_NEAR(m.transmittance, 0.45 * 0.56, 1e-15);
  EXPECT_NEAR(m.light, 0.35 + 0.45 * (0.2 * 0.7 + 0.4), 1e-15);
}

TEST(MarchSegment, MatchesTheIntegralAtFirstOrder) {
  // Air and cloud mixed evenly: dI = (a + c) T, T = e^-(alpha + gamma) s. 64 slices are off by 0.2 %.
  const double alpha = 0.4, gamma = 3.1, of_air = 0.3, of_cloud = 2.0;
  const double exact = (of_air + of_cloud) / (alpha + gamma) * (1.0 - std::exp(-alpha - gamma));
  double before = 0.0;
  for (const int n : {64, 128}) {
    f64::Marched m = f64::not_marched();
    const double s = 1.0 / n;
    const double air = std::exp(-alpha * s), cloud = std::exp(-gamma * s);
    for (int i = 0; i < n; ++i) {
      f64::march_segment(m, air, of_air / alpha * (1.0 - air), cloud, of_cloud / gamma * (1.0 - cloud));
    }
    EXPECT_NEAR(m.transmittance, std::exp(-alpha - gamma), 1e-13);
    const double error = m.light / exact - 1.0;
    EXPECT_LT(std::fabs(error), 4e-3 * 64 / n);
    if (before != 0.0) {
      EXPECT_NEAR(error / before, 0.5, 0.05);
    }
    before = error;
  }
}

TEST(CloudSignal, IsAParabolaBetweenBottomAndTop) {
  EXPECT_EQ(f64::cloud_signal(1000.0, 1000.0, 3000.0), 0.0);
  EXPECT_EQ(f64::cloud_signal(3000.0, 1000.0, 3000.0), 0.0);
  EXPECT_EQ(f64::cloud_signal(2000.0, 1000.0, 3000.0), 1.0);
  EXPECT_EQ(f64::cloud_signal(500.0, 1000.0, 3000.0), 0.0);
  EXPECT_EQ(f64::cloud_signal(9000.0, 1000.0, 3000.0), 0.0);
  for (double x = 0.0; x <= 1.0; x += 0.01) {
    EXPECT_NEAR(f64::cloud_signal(1000.0 + 2000.0 * x, 1000.0, 3000.0), 4.0 * x * (1.0 - x), 1e-14);
  }
}

}  // namespace
}  // namespace terrella
