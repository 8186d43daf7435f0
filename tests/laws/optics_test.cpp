#include <gtest/gtest.h>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

constexpr double pi = std::numbers::pi;

TEST(Schlick, RunsFromItsReflectanceAtNormalToOneAndNeverRises) {
  const double r0 = f64::reflectance_at_normal(1.0, 1.333);
  EXPECT_NEAR(r0, 0.02037, 1e-5);
  EXPECT_DOUBLE_EQ(f64::schlick(1.0, r0), r0);
  EXPECT_DOUBLE_EQ(f64::schlick(0.0, r0), 1.0);
  for (double c = 0.0; c < 1.0; c += 0.001) {
    EXPECT_GE(f64::schlick(c, r0), f64::schlick(c + 0.001, r0));
    EXPECT_GE(f64::schlick(c, r0), r0);
    EXPECT_LE(f64::schlick(c, r0), 1.0);
  }
}

TEST(Schlick, TakesCosinesThatRoundingPushedOverTheirEnds) {
  EXPECT_EQ(f32::schlick(1.0F + 2.4e-7F, 0.02F), 0.02F);
  EXPECT_EQ(f32::schlick(-0.3F, 0.02F), 1.0F);
}

TEST(Schlick, StaysCloseToFresnel) {
  // Measured: 0.0592 at the most between air and water.
  const double n = 1.333, r0 = f64::reflectance_at_normal(1.0, n);
  for (double c = 0.01; c <= 1.0; c += 0.01) {
    const double t = std::sqrt(1.0 - (1.0 - c * c) / (n * n));
    const double s = (c - n * t) / (c + n * t), p = (n * c - t) / (n * c + t);
    EXPECT_NEAR(f64::schlick(c, r0), 0.5 * (s * s + p * p), 0.06);
  }
}

TEST(CrustCover, GrowsWithTheCrustAndWithTheDistanceFromTheLinesWhereItIsTorn) {
  for (double crust = 0.0; crust <= 1.0; crust += 0.05) {
    double before = 0.0;
    for (double noise = 0.0; noise <= 1.0; noise += 0.01) {
      const double cover = f64::crust_cover(noise, crust);
      EXPECT_GE(cover, before);
      EXPECT_LE(cover, 1.0);
      EXPECT_EQ(cover, f64::crust_cover(-noise, crust));
      EXPECT_LE(cover, f64::crust_cover(noise, std::fmin(1.0, crust + 0.05)) + 1e-12);
      before = cover;
    }
  }
  EXPECT_EQ(f64::crust_cover(1.0, 0.0), 0.0);
  EXPECT_EQ(f64::crust_cover(0.0, 1.0), 1.0);
}

TEST(WrapDiffuse, IsLambertWithoutWrapAndReachesRoundWithIt) {
  for (double c = -1.0; c <= 1.0; c += 0.01) {
    EXPECT_DOUBLE_EQ(f64::wrap_diffuse(c, 0.0), std::fmax(c, 0.0));
    EXPECT_GE(f64::wrap_diffuse(c, 0.5), f64::wrap_diffuse(c, 0.0));
  }
  EXPECT_DOUBLE_EQ(f64::wrap_diffuse(1.0, 0.5), 1.0);
  EXPECT_DOUBLE_EQ(f64::wrap_diffuse(-0.5, 0.5), 0.0);
}

TEST(WrapDiffuse, GivesAHemisphereOnePlusWrapTimesLambert) {
  for (const double wrap : {0.0, 0.25, 0.5, 1.0}) {
    double sum = 0.0;
    const int n = 20'000;
    for (int i = 0; i < n; ++i) sum += f64::wrap_diffuse(-1.0 + 2.0 * (i + 0.5) / n, wrap) * 2.0 / n;
    EXPECT_NEAR(2.0 * pi * sum, pi * (1.0 + wrap), 1e-4);
  }
}

TEST(Transmitted, MultipliesAlongAPath) {
  const glm::dvec3 extinction(3.0, 0.5, 0.1);
  const glm::dvec3 whole = f64::transmitted(extinction, 1.7);
  const glm::dvec3 parts = f64::transmitted(extinction, 0.6) * f64::transmitted(extinction, 1.1);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(whole[c], parts[c], 1e-15);
  EXPECT_EQ(f64::transmitted(extinction, 0.0), glm::dvec3(1.0));
  EXPECT_EQ(f64::transmitted(extinction, -1.0), glm::dvec3(1.0));
}

TEST(ExtinctionOf, GivesTheTintAfterOneLength) {
  const glm::dvec3 tint(0.1, 0.6, 0.9);
  const glm::dvec3 back = f64::transmitted(f64::extinction_of(tint), 1.0);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(back[c], tint[c], 1e-12);
  EXPECT_TRUE(std::isfinite(f64::extinction_of(glm::dvec3(0.0)).x));
}

TEST(Glitter, SendsBackNoMoreLightThanFalls) {
  // The lobe without its Fresnel factor, over all directions of view, for lights at several heights.
  test::Places places(41U);
  for (const double roughness : {0.2, 0.5, 1.0}) {
    for (const double light_cosine : {0.2, 0.6, 0.95}) {
      const glm::dvec3 light(std::sqrt(1.0 - light_cosine * light_cosine), 0.0, light_cosine);
      double sum = 0.0;
      const int count = 400'000;
      for (int i = 0; i < count; ++i) {
        glm::dvec3 view = places.on_sphere();
        view.z = std::fabs(view.z);
        const glm::dvec3 half = glm::normalize(light + view);
        // Glitter holds the light's cosine; reflected energy is weighted by the view's.
        sum += f64::glitter(half.z, view.z, light.z, roughness) / light.z * view.z * 2.0 * pi / count;
      }
      EXPECT_LT(sum, 1.05) << roughness << " " << light_cosine;
      EXPECT_GT(sum, 0.3) << roughness << " " << light_cosine;
    }
  }
}

TEST(Phong, HasTheSameEnergyForEveryExponent) {
  for (const double exponent : {1.0, 60.0, 1000.0}) {
    double sum = 0.0;
    const int n = 200'000;
    for (int i = 0; i < n; ++i) {
      const double c = (i + 0.5) / n;
      sum += f64::phong(c, exponent) * c * 2.0 * pi / n;
    }
    EXPECT_NEAR(sum, 1.0, 1e-3) << exponent;
  }
}

}  // namespace
}  // namespace terrella
