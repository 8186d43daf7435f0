#include <gtest/gtest.h>

#include <cmath>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

constexpr double fine = 1e-4;

TEST(RingMatter, IsWithinItsBoundsAndNoneBeyondItsEdges) {
  double least = 1.0, most = 0.0;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    for (int i = 0; i <= 1000; ++i) {
      const double matter = f64::ring_matter(i / 1000.0, fine, seed);
      ASSERT_GE(matter, 0.0);
      ASSERT_LE(matter, 1.0);
      if (i > 50 && i < 950) least = std::fmin(least, matter), most = std::fmax(most, matter);
    }
    EXPECT_EQ(f64::ring_matter(0.0, fine, seed), 0.0);
    EXPECT_EQ(f64::ring_matter(1.0, fine, seed), 0.0);
    EXPECT_EQ(f64::ring_matter(-3.0, fine, seed), 0.0);
    EXPECT_EQ(f64::ring_matter(3.0, fine, seed), 0.0);
  }
  EXPECT_LT(least, 0.05);  // gaps
  EXPECT_GT(most, 0.95);   // and dense ringlets
}

TEST(RingMatter, ChangesLittleBetweenNeighbouringSamples) {
  for (const double footprint : {0.001, 0.01, 0.1}) {
    double largest = 0.0;
    for (double x = 0.1; x < 0.9; x += footprint / 7.0) {
      largest = std::fmax(largest,
                          std::abs(f64::ring_matter(x + footprint, footprint, 3) - f64::ring_matter(x, footprint, 3)));
    }
    EXPECT_LT(largest, 0.75) << footprint;  // measured: 0.16, 0.62, 0.69
  }
}

TEST(RingOpacity, GrowsWithMatterAndWithTheWayThroughIt) {
  EXPECT_EQ(f64::ring_opacity(0.0, 0.9, 1.0), 0.0);
  EXPECT_NEAR(f64::ring_opacity(1.0, 0.9, 1.0), 0.9, 1e-12);
  EXPECT_NEAR(f64::ring_opacity(1.0, 0.9, -0.5), 0.99, 1e-12);  // twice the way
  EXPECT_GT(f64::ring_opacity(0.5, 0.9, 0.3), f64::ring_opacity(0.4, 0.9, 0.3));
  EXPECT_LE(f64::ring_opacity(1.0, 1.0, 0.0), 1.0);
}

TEST(RingShade, FallsOnlyWhereTheWayToTheSunCrossesTheRings) {
  const glm::dvec3 sun = glm::normalize(glm::dvec3(1.0, 0.0, 0.5));
  f64::Rings rings;
  rings.inner = 1.5;
  rings.outer = 2.5;
  rings.density = 1.0;
  rings.seed = 3U;
  const auto shade = [&](const glm::dvec3& place) { return f64::ring_shade(place, sun, rings, fine); };
  EXPECT_EQ(shade(glm::normalize(glm::dvec3(1.0, 0.0, 0.1))), 1.0);  // on the sun's side of them
  EXPECT_EQ(shade({1.0, 0.0, 0.0}), 1.0);
  EXPECT_EQ(shade({0.8, 0.0, -0.2}), 1.0);  // crosses at 1.2, within them
  EXPECT_EQ(shade({0.6, 0.0, -1.0}), 1.0);  // crosses at 2.6, beyond
  double darkest = 1.0;
  for (double z = -0.85; z < -0.4; z += 0.01) darkest = std::fmin(darkest, shade({0.7, 0.0, z}));
  EXPECT_LT(darkest, 0.01);
}

TEST(PlanetShade, IsItsShadowWithASoftEdge) {
  const glm::dvec3 sun(0.0, 1.0, 0.0);
  EXPECT_EQ(f64::planet_shade({0.5, 2.0, 0.0}, sun), 1.0);
  EXPECT_EQ(f64::planet_shade({0.5, -2.0, 0.0}, sun), 0.0);
  EXPECT_EQ(f64::planet_shade({1.5, -2.0, 0.0}, sun), 1.0);
  EXPECT_NEAR(f64::planet_shade({1.0, -2.0, 0.0}, sun), 0.5, 1e-12);
}

TEST(LineNoise, RunsWithoutAStepOrAnEdgeThroughItsValues) {
  for (int x = -5; x < 5; ++x) {
    const double at = f64::line_noise(x, 2, 7U);
    EXPECT_GE(at, 0.0);
    EXPECT_LE(at, 1.0);
    EXPECT_NEAR(f64::line_noise(x - 1e-6, 2, 7U), at, 1e-10);
    EXPECT_NEAR(f64::line_noise(x + 1e-6, 2, 7U), at, 1e-10);
    EXPECT_NEAR(f64::line_noise(x + 0.5, 2, 7U), 0.5 * (at + f64::line_noise(x + 1, 2, 7U)), 1e-12);
  }
  EXPECT_NE(f64::line_noise(3.0, 2, 7U), f64::line_noise(3.0, 1, 7U));
  EXPECT_NE(f64::line_noise(3.0, 2, 7U), f64::line_noise(3.0, 2, 8U));
}

// Coarse samples see the mean of all layers, which lies where the gaps' noise ends: no ringlet, no gap.
TEST(RingMatter, IsTheSameAllOverWhereSamplesShowNoRinglet) {
  const double even = f64::ring_matter(0.5, 0.2, 3U);
  EXPECT_GT(even, 0.3);
  EXPECT_LT(even, 0.6);
  for (double x = 0.3; x < 0.7; x += 0.01) EXPECT_NEAR(f64::ring_matter(x, 0.2, 3U), even, 1e-12);
}

TEST(RingOpacity, OfRingsSeenFaceOnIsTheirDensityTimesTheirMatter) {
  for (const double density : {0.1, 0.5, 0.99}) {
    for (const double side : {1.0, -1.0}) {
      EXPECT_NEAR(f64::ring_opacity(1.0, density, side), density, 1e-12);
      EXPECT_NEAR(f64::ring_opacity(0.4, density, side), 0.4 * density, 1e-12);
    }
    // What is left of light multiplies with the way.
    const double left = 1.0 - density;
    EXPECT_NEAR(f64::ring_opacity(1.0, density, 0.25), 1.0 - left * left * left * left, 1e-12);
  }
}

f64::Rings some_rings() {
  f64::Rings rings;
  rings.inner = 1.5;
  rings.outer = 2.5;
  rings.density = 0.8;
  rings.color = {0.9, 0.7, 0.5};
  rings.seed = 3U;
  return rings;
}

f64::SceneLight scene_under(const glm::dvec3& sun) {
  f64::SceneLight scene;
  scene.eye = {0.0, 0.0, 5.0};
  scene.eye_height = 4.0;
  scene.sun = sun;
  scene.sunlight = {2.0, 1.8, 1.5};
  scene.ambient = 0.0;
  scene.sky_glow = glm::dvec3(0.0);
  scene.air = {1.1, 0.5, 3.0, 0.2, glm::dvec3(1.0), glm::dvec3(1.0)};
  return scene;
}

// The place with the most matter, beside the planet as the sun of +x sees it.
glm::dvec3 dense_place(const f64::Rings& rings) {
  glm::dvec3 best(0.0);
  double most = 0.0;
  for (double r = 1.55; r < 2.45; r += 0.001) {
    const double matter = f64::ring_matter(f64::across_rings({0.0, r, 0.0}, rings), fine, rings.seed);
    if (matter > most) most = matter, best = {0.0, r, 0.0};
  }
  EXPECT_GT(most, 0.95);
  return best;
}

TEST(AcrossRings, CountsFromTheInnerEdgeToTheOuterOne) {
  const f64::Rings rings = some_rings();
  EXPECT_NEAR(f64::across_rings({1.5, 0.0, 0.0}, rings), 0.0, 1e-12);
  EXPECT_NEAR(f64::across_rings({0.0, -2.5, 0.0}, rings), 1.0, 1e-12);
  EXPECT_NEAR(f64::across_rings({1.2, 1.6, 0.0}, rings), 0.5, 1e-12);
  f64::Rings narrow = rings;
  narrow.outer = narrow.inner;
  EXPECT_TRUE(std::isfinite(f64::across_rings({2.0, 0.0, 0.0}, narrow)));
}

TEST(RingShade, IsWhatTheRingsOnTheWayToTheSunLeave) {
  const f64::Rings rings = some_rings();
  const glm::dvec3 sun = glm::normalize(glm::dvec3(0.6, 0.2, -0.7));
  const glm::dvec3 place(0.4, 0.3, 0.8), crossing = place + 0.8 / 0.7 * glm::dvec3(0.6, 0.2, -0.7);
  EXPECT_NEAR(crossing.z, 0.0, 1e-12);
  glm::dvec3 at = dense_place(rings);
  at = glm::length(at) * glm::normalize(crossing);
  // Back along the sun's ray from a dense place of the plane.
  const glm::dvec3 under = at - 1.1 * sun;
  const double matter = f64::ring_matter(f64::across_rings(at, rings), fine, rings.seed);
  EXPECT_NEAR(f64::ring_shade(under, sun, rings, fine), 1.0 - f64::ring_opacity(matter, rings.density, sun.z), 1e-9);
  EXPECT_EQ(f64::ring_shade(under, -sun, rings, fine), 1.0);
}

TEST(RingVeil, IsLitFromTheSideThatIsSeenAndLessThroughThem) {
  const f64::Rings rings = some_rings();
  const f64::SceneLight scene = scene_under(glm::normalize(glm::dvec3(0.8, 0.0, 0.6)));
  const glm::dvec3 at = dense_place(rings), down(0.0, 0.0, -1.0);
  const double matter = f64::ring_matter(f64::across_rings(at, rings), fine, rings.seed);
  const f64::Veil lit = f64::ring_veil(at, down, rings, fine, scene);
  EXPECT_NEAR(lit.opacity, rings.density * matter, 1e-12);
  const glm::dvec3 most = 0.35 * rings.color * scene.sunlight;
  EXPECT_LT(glm::distance(lit.light / lit.opacity, (0.7 + 0.3 * matter) * most), 1e-12);
  const f64::Veil through = f64::ring_veil(at, -down, rings, fine, scene);
  EXPECT_EQ(through.opacity, lit.opacity);
  EXPECT_LT(glm::distance(through.light, 0.5 * (1.0 - lit.opacity) * lit.light), 1e-12);
}

TEST(RingVeil, IsNothingBesideTheRingsAndDarkInThePlanetsShadow) {
  const f64::Rings rings = some_rings();
  f64::SceneLight scene = scene_under(glm::normalize(glm::dvec3(0.8, 0.0, 0.6)));
  const glm::dvec3 at = dense_place(rings), down(0.0, 0.0, -1.0);
  EXPECT_EQ(f64::ring_veil({1.4, 0.0, 0.0}, down, rings, fine, scene).opacity, 0.0);
  EXPECT_EQ(f64::ring_veil({2.6, 0.0, 0.0}, down, rings, fine, scene).light, glm::dvec3(0.0));
  const glm::dvec3 behind(-1.56, 0.0, 0.0);  // the sun's ray passes the centre at 0.94
  EXPECT_EQ(f64::ring_veil(behind, down, rings, fine, scene).light, glm::dvec3(0.0));
  scene.sun = {1.0, 0.0, 0.0};  // along the plane
  EXPECT_EQ(f64::ring_veil(at, down, rings, fine, scene).light, glm::dvec3(0.0));
  scene.ambient = 0.5;
  const f64::Veil faint = f64::ring_veil(at, down, rings, fine, scene);
  const double matter = f64::ring_matter(f64::across_rings(at, rings), fine, rings.seed);
  EXPECT_LT(glm::distance(faint.light / faint.opacity, 0.01 * (0.7 + 0.3 * matter) * rings.color * scene.sunlight),
            1e-12);
}

TEST(RingShadow, LiesByDayWhereTheRingsHideTheSun) {
  const f64::Rings rings = some_rings();
  const f64::SceneLight scene = scene_under(glm::normalize(glm::dvec3(0.8, 0.0, 0.6)));
  double darkest = 0.0;
  for (double z = -0.9; z < 0.9; z += 0.01) {
    const glm::dvec3 place(std::sqrt(1.0 - z * z), 0.0, z);
    const double shadow = f64::ring_shadow(place, rings, scene);
    const double taken = 1.0 - f64::ring_shade(place, scene.sun, rings, f64::ring_shadow_blur);
    EXPECT_GE(shadow, 0.0);
    if (glm::dot(place, scene.sun) > 0.15) {
      EXPECT_NEAR(shadow, 0.85 * taken, 1e-12);
      EXPECT_NEAR(f64::ring_shadow(1.05 * place, rings, scene),
                  0.85 * (1.0 - f64::ring_shade(1.05 * place, scene.sun, rings, f64::ring_shadow_blur)), 1e-12);
    }
    if (glm::dot(place, scene.sun) < 0.0) {
      EXPECT_EQ(shadow, 0.0);
    }
    darkest = std::fmax(darkest, shadow);
  }
  EXPECT_GT(darkest, 0.3);
}

}  // namespace
}  // namespace terrella
