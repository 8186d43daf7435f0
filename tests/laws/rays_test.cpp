#include <gtest/gtest.h>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"
#include "laws/rounding.hpp"

namespace terrella {
namespace {

using test::Places;
using test::roundoff;

TEST(RaySphere, RootsLieOnTheSphereInOrder) {
  Places places(231U);
  int met = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double r = places.between(0.5, 3.0);
    const glm::dvec3 o = places.in_cube(4.0), d = places.between(0.1, 5.0) * places.on_sphere();
    const f64::Roots t = f64::ray_sphere(o, d, r);
    const glm::dvec3 foot = o - glm::dot(o, d) / glm::dot(d, d) * d;
    ASSERT_EQ(t.met, glm::length(foot) <= r);
    if (!t.met) {
      ASSERT_TRUE(t.t0 == 0.0 && t.t1 == 0.0);
      continue;
    }
    ++met;
    const double chord = std::sqrt(r * r - glm::dot(foot, foot));
    ASSERT_LE(t.t0, t.t1);
    ASSERT_NEAR(glm::length(o + t.t0 * d), r, 1e-11 / (chord + 1e-3));
    ASSERT_NEAR(glm::length(o + t.t1 * d), r, 1e-11 / (chord + 1e-3));
    ASSERT_NEAR(f64::ray_sphere(o, 2.0 * d, r).t1, 0.5 * t.t1, 1e-12);
  }
  EXPECT_GT(met, 3000);
}

TEST(RaySphere, FromTheSphereItselfOneRootIsNothing) {
  const f64::Roots out = f64::ray_sphere({2.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 2.0);
  EXPECT_EQ(out.t0, -4.0);
  EXPECT_EQ(out.t1, 0.0);
  const f64::Roots touching = f64::ray_sphere({2.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 2.0);
  EXPECT_TRUE(touching.met);
  EXPECT_EQ(touching.t0, 0.0);
  EXPECT_EQ(touching.t1, 0.0);
}

TEST(RayShell, IsARayAndASphereToldByAltitudes) {
  Places places(232U);
  for (int i = 0; i < 40'000; ++i) {
    const double r = places.between(0.5, 3.0), alt = places.between(0.0, 4.0), h = places.between(0.0, 2.0);
    const double mu = places.between(-1.0, 1.0);
    const f64::Roots t = f64::ray_shell(r, alt, mu, h);
    const f64::Roots s = f64::ray_sphere({0.0, 0.0, r + alt}, {std::sqrt(1.0 - mu * mu), 0.0, mu}, r + h);
    const double nearest = (r + alt) * std::sqrt(1.0 - mu * mu);
    if (std::fabs(nearest - r - h) < 1e-9) continue;
    ASSERT_EQ(t.met, s.met);
    const double chord = std::sqrt(std::fabs((r + h) * (r + h) - nearest * nearest));
    ASSERT_NEAR(t.t0, s.t0, 1e-12 / (chord + 1e-6));
    ASSERT_NEAR(t.t1, s.t1, 1e-12 / (chord + 1e-6));
  }
}

TEST(RayShell, KeepsCentimetresAtTheEarthAndFromFarAway) {
  // Straight down and up: the roots are differences of altitudes.
  const f32::Roots down = f32::ray_shell(6.36e6F, 0.5F, -1.0F, 0.1F);
  EXPECT_NEAR(down.t0, double{0.5F} - double{0.1F}, 16.0 * roundoff * 0.4);
  const f32::Roots up = f32::ray_shell(6.36e6F, 0.1F, 1.0F, 0.5F);
  EXPECT_NEAR(up.t1, double{0.5F} - double{0.1F}, 16.0 * roundoff * 0.4);
  const f32::Roots far = f32::ray_shell(6.36e6F, 1e9F, -1.0F, 0.0F);
  EXPECT_NEAR(far.t0, 1e9, 16.0 * roundoff * 1e9);
  EXPECT_NEAR(far.t1, 1e9 + 2.0 * 6.36e6, 16.0 * roundoff * 1e9);
  EXPECT_FALSE(f32::ray_shell(6.36e6F, 1e5F, 0.0F, 0.0F).met);
}

}  // namespace
}  // namespace terrella
