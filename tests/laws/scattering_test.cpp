#include <gtest/gtest.h>

#include <functional>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

using test::Places;

f64::Atmosphere earth() {
  f64::Atmosphere a;
  a.bottom = 6.36e6;
  a.thickness = 6e4;
  a.rayleigh = {5.802e-6, 13.558e-6, 33.1e-6};
  a.rayleigh_height = 8000.0;
  a.mie = glm::dvec3(4.44e-6);
  a.mie_height = 1200.0;
  a.ozone = {0.65e-6, 1.881e-6, 0.085e-6};
  a.ozone_center = 25000.0;
  a.ozone_half = 15000.0;
  return a;
}

const glm::dvec3 haze(3.996e-6);

// Over all directions, by the midpoint rule; fine where forward peaks are sharp.
double over_sphere(const std::function<double(double)>& of_mu) {
  double sum = 0.0;
  const int steps = 400'000;
  for (int i = 0; i < steps; ++i) {
    const double s = (i + 0.5) / steps, mu = 1.0 - 2.0 * s * s;  // denser forward
    sum += of_mu(mu) * 4.0 * s / steps;
  }
  return 2.0 * std::numbers::pi * sum;
}

TEST(Phase, OfAirHasIntegralOneAndIsTheSameForwardAndBack) {
  EXPECT_NEAR(over_sphere([](double mu) { return f64::rayleigh_phase(mu); }), 1.0, 1e-9);
  EXPECT_EQ(f64::rayleigh_phase(0.6), f64::rayleigh_phase(-0.6));
  EXPECT_NEAR(f64::rayleigh_phase(1.0) / f64::rayleigh_phase(0.0), 2.0, 1e-15);
}

TEST(Phase, OfHazeHasIntegralOneAndItsMeanCosine) {
  for (const double g : {-0.6, 0.0, 0.3, 0.76, 0.95}) {
    EXPECT_NEAR(over_sphere([g](double mu) { return f64::henyey_greenstein_phase(mu, g); }), 1.0, 1e-6) << g;
    EXPECT_NEAR(over_sphere([g](double mu) { return mu * f64::henyey_greenstein_phase(mu, g); }), g, 1e-6) << g;
  }
  EXPECT_NEAR(f64::henyey_greenstein_phase(0.3, 0.0), 0.25 / std::numbers::pi, 1e-15);
  // The printed denominator is 0 here in single precision.
  const double g = double{0.9999F};
  const double expected = (1.0 + g) / (4.0 * std::numbers::pi * (1.0 - g) * (1.0 - g));
  EXPECT_NEAR(f32::henyey_greenstein_phase(1.0F, 0.9999F), expected, 8e-7 * expected);
}

TEST(AltitudeAlong, IsThatOfThePlaceOnTheRay) {
  Places places(241U);
  for (int i = 0; i < 10'000; ++i) {
    const double alt = places.between(0.0, 6e4), mu = places.between(-1.0, 1.0), way = places.between(0.0, 1e6);
    const double x = way * std::sqrt(1.0 - mu * mu), y = 6.36e6 + alt + way * mu;
    ASSERT_NEAR(f64::radius_along(alt, mu, way, 6.36e6), std::hypot(x, y), 1e-7);
    ASSERT_NEAR(f64::altitude_along(alt, mu, way, 6.36e6), std::hypot(x, y) - 6.36e6, 1e-7);
  }
}

TEST(Extinction, IsThatOfEachPart) {
  const f64::Atmosphere a = earth();
  const glm::dvec3 ground = f64::extinction_at(0.0, a);
  EXPECT_LT(glm::distance(ground, a.rayleigh + a.mie), 1e-18);  // no ozone down here
  const glm::dvec3 middle = f64::extinction_at(25000.0, a);
  const glm::dvec3 rest = a.rayleigh * std::exp(-25.0 / 8.0) + a.mie * std::exp(-25.0 / 1.2);
  EXPECT_LT(glm::distance(middle, rest + a.ozone), 1e-18);
  EXPECT_LT(glm::distance(f64::extinction_at(17500.0, a),
                          a.rayleigh * std::exp(-17.5 / 8.0) + a.mie * std::exp(-17.5 / 1.2) + 0.5 * a.ozone),
            1e-18);
}

TEST(OpticalDepth, OfStraightUpAndAlongTheGround) {
  const f64::Atmosphere a = earth();
  const glm::dvec3 zenith = glm::exp(-f64::optical_depth_to_top(0.0, 1.0, a));
  EXPECT_NEAR(zenith.r, 0.94038, 5e-6);
  EXPECT_NEAR(zenith.g, 0.86767, 5e-6);
  EXPECT_NEAR(zenith.b, 0.76242, 5e-6);
  const glm::dvec3 level = glm::exp(-f64::optical_depth_to_top(0.0, 0.0, a));
  EXPECT_NEAR(level.r, 0.10645, 5e-6);
  EXPECT_NEAR(level.g, 0.0095837, 5e-8);
  EXPECT_NEAR(level.b, 5.2123e-5, 5e-10);
  // Straight up it has a closed form.
  for (int i = 0; i < 3; ++i) {
    const double closed =
        a.rayleigh[i] * 8000.0 * -std::expm1(-7.5) + a.mie[i] * 1200.0 * -std::expm1(-50.0) + a.ozone[i] * 15000.0;
    EXPECT_NEAR(f64::optical_depth_to_top(0.0, 1.0, a)[i], closed, 1e-10 * closed);
  }
}

TEST(OpticalDepth, AddsUpAlongARayAndIsTheSameBothWays) {
  const f64::Atmosphere a = earth();
  Places places(242U);
  for (int i = 0; i < 300; ++i) {
    const double alt = places.between(0.0, 5.5e4), r = a.bottom + alt;
    const double lowest = -std::sqrt(alt * (2.0 * a.bottom + alt)) / r;
    const double mu = places.between(lowest, i % 2 == 0 ? 1.0 : 0.1);
    const double way = f64::way_to_top(alt, mu, a) * places.between(0.1, 1.0), part = way * places.between(0.0, 1.0);
    const double there = f64::radius_along(alt, mu, part, a.bottom), end = f64::radius_along(alt, mu, way, a.bottom);
    const glm::dvec3 whole = f64::optical_depth(alt, mu, way, a);
    const glm::dvec3 first = f64::optical_depth(alt, mu, part, a);
    const glm::dvec3 rest =
        f64::optical_depth(f64::altitude_along(alt, mu, part, a.bottom), (r * mu + part) / there, way - part, a);
    const glm::dvec3 back =
        f64::optical_depth(f64::altitude_along(alt, mu, way, a.bottom), -(r * mu + way) / end, way, a);
    for (int c = 0; c < 3; ++c) {
      ASSERT_NEAR(first[c] + rest[c], whole[c], 1e-8 * whole[c] + 1e-12);
      ASSERT_NEAR(back[c], whole[c], 1e-8 * whole[c] + 1e-12);
    }
  }
}

TEST(OpticalDepth, IsTheIntegralByBruteForce) {
  const f64::Atmosphere a = earth();
  Places places(243U);
  for (int i = 0; i < 20; ++i) {
    const double alt = places.between(0.0, 4e4);
    const double lowest = -std::sqrt(alt * (2.0 * a.bottom + alt)) / (a.bottom + alt);
    const double mu = places.between(lowest, 0.3), way = f64::way_to_top(alt, mu, a);
    EXPECT_NEAR(f64::altitude_along(alt, mu, way, a.bottom), a.thickness, 1e-6);
    glm::dvec3 sum(0.0);
    const int steps = 100'000;
    for (int k = 0; k < steps; ++k) {
      const double s = way * (k + 0.5) / steps, x = s * std::sqrt(1.0 - mu * mu), y = a.bottom + alt + s * mu;
      sum += way / steps * f64::extinction_at(std::hypot(x, y) - a.bottom, a);
    }
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(f64::optical_depth_to_top(alt, mu, a)[c], sum[c], 1e-7 * sum[c]);
  }
}

TEST(BehindGround, IsBelowTheHorizon) {
  const f64::Atmosphere a = earth();
  for (const double alt : {1.0, 1e3, 5e4}) {
    const double lowest = -std::sqrt(alt * (2.0 * a.bottom + alt)) / (a.bottom + alt);
    EXPECT_TRUE(f64::behind_ground(alt, lowest - 1e-6, a));
    EXPECT_FALSE(f64::behind_ground(alt, lowest + 1e-6, a));
    EXPECT_FALSE(f64::behind_ground(alt, 1.0, a));
  }
}

struct Ray {
  double alt, mu, mu_sun, nu, way;
};

Ray some_ray(Places& places) {
  Ray ray{};
  ray.alt = places.between(10.0, 5e4);
  ray.mu = places.between(-1.0, 1.0);
  ray.mu_sun = places.between(-0.2, 1.0) * (places.between(0.0, 1.0) < 0.5 ? 0.3 : 1.0);
  const double side = std::sqrt((1.0 - ray.mu * ray.mu) * (1.0 - ray.mu_sun * ray.mu_sun));
  ray.nu = ray.mu * ray.mu_sun + side * std::cos(places.between(0.0, 3.14));
  const f64::Roots ground = f64::ray_shell(6.36e6, ray.alt, ray.mu, 0.0);
  const f64::Roots top = f64::ray_shell(6.36e6, ray.alt, ray.mu, 6e4);
  ray.way = 0.999 * (ray.mu < 0.0 && ground.met ? ground.t0 : top.t1);
  return ray;
}

f64::Scattered scattered(const Ray& ray, const f64::Atmosphere& a) {
  return f64::single_scatter(ray.alt, ray.mu, ray.mu_sun, ray.nu, ray.way, haze, a);
}

// The same ray from a place along it on.
Ray rest_of(const Ray& ray, double part, const f64::Atmosphere& a) {
  const double r = a.bottom + ray.alt, there = f64::radius_along(ray.alt, ray.mu, part, a.bottom);
  return {f64::altitude_along(ray.alt, ray.mu, part, a.bottom), (r * ray.mu + part) / there,
          (r * ray.mu_sun + part * ray.nu) / there, ray.nu, ray.way - part};
}

TEST(SingleScatter, AddsUpBehindWhatIsInFront) {
  const f64::Atmosphere a = earth();
  Places places(244U);
  for (int i = 0; i < 12; ++i) {
    const Ray ray = some_ray(places);
    const double part = ray.way * places.between(0.1, 0.9);
    Ray front = ray;
    front.way = part;
    const f64::Scattered whole = scattered(ray, a), first = scattered(front, a),
                         rest = scattered(rest_of(ray, part, a), a);
    const glm::dvec3 left = glm::exp(-f64::optical_depth(ray.alt, ray.mu, part, a));
    const double bound = 1e-6 * std::fmax(whole.rayleigh.r, std::fmax(whole.rayleigh.g, whole.rayleigh.b)) + 1e-12;
    ASSERT_LT(glm::distance(first.rayleigh + left * rest.rayleigh, whole.rayleigh), bound) << i;
    ASSERT_LT(glm::distance(first.mie + left * rest.mie, whole.mie), 1e-6 * whole.mie.r + 1e-12) << i;
  }
}

// Sums in small steps, the sun's shadow found by where the sun's ray meets the ground.
TEST(SingleScatter, IsTheIntegralByBruteForce) {
  const f64::Atmosphere a = earth();
  Places places(245U);
  for (int i = 0; i < 6; ++i) {
    const Ray ray = some_ray(places);
    glm::dvec3 air(0.0), mist(0.0), depth(0.0);
    const int steps = 4000;
    for (int k = 0; k < steps; ++k) {
      const double piece = ray.way / steps;
      const Ray here = rest_of(ray, piece * (k + 0.5), a);
      const glm::dvec3 extinction = f64::extinction_at(here.alt, a);
      const f64::Roots ground = f64::ray_shell(a.bottom, here.alt, here.mu_sun, 0.0);
      if (!(ground.met && ground.t1 > 0.0)) {
        const glm::dvec3 left =
            glm::exp(-depth - 0.5 * piece * extinction - f64::optical_depth_to_top(here.alt, here.mu_sun, a));
        air += piece * std::exp(-here.alt / a.rayleigh_height) * left;
        mist += piece * std::exp(-here.alt / a.mie_height) * left;
      }
      depth += piece * extinction;
    }
    const f64::Scattered light = scattered(ray, a);
    const glm::dvec3 expected = a.rayleigh * air;
    const double bound = 2e-3 * std::fmax(expected.r, std::fmax(expected.g, expected.b)) + 1e-12;
    ASSERT_LT(glm::distance(light.rayleigh, expected), bound) << i;
    ASSERT_LT(glm::distance(light.mie, haze * mist), 2e-3 * haze.r * std::fmax(mist.r, mist.b) + 1e-12) << i;
  }
}

TEST(SingleScatter, IsDarkInThePlanetsShadow) {
  const f64::Atmosphere a = earth();
  const f64::Scattered night = f64::single_scatter(100.0, 1.0, -0.5, -0.5, 5.9e4, haze, a);
  EXPECT_EQ(night.rayleigh, glm::dvec3(0.0));
  EXPECT_EQ(night.mie, glm::dvec3(0.0));
  const f64::Scattered twilight = f64::single_scatter(100.0, 1.0, -0.05, -0.05, 5.9e4, haze, a);  // lit from 8 km on
  EXPECT_GT(twilight.rayleigh.r, 0.0);
}

// A ray past the dark side of the planet, at right angles to the sun and 500 km behind it: it enters the shadow, runs
// through it above the ground, and leaves it. In kilometres along the ray from its lowest place the shadow is from
// -356.5 to 356.5.
TEST(SingleScatter, IsSplitWhereTheRayEntersAndLeavesTheShadow) {
  const f64::Atmosphere a = earth();
  const double behind = 5e5, nearest = 6.35e6, start = 4e5;
  const double r = std::sqrt(behind * behind + nearest * nearest + start * start);
  const double edge = std::sqrt(a.bottom * a.bottom - nearest * nearest);
  const Ray ray = {r - a.bottom, -start / r, -behind / r, 0.0, 2.0 * start};
  Ray lit = ray, dark = ray;
  lit.way = start - edge;
  dark.way = start + edge;
  const f64::Scattered whole = scattered(ray, a), before = scattered(lit, a), until = scattered(dark, a);
  const f64::Scattered rest = scattered(rest_of(ray, dark.way, a), a);
  EXPECT_GT(before.rayleigh.r, 0.0);
  EXPECT_LT(glm::distance(until.rayleigh, before.rayleigh), 1e-8 * before.rayleigh.r);
  EXPECT_LT(glm::distance(until.mie, before.mie), 1e-8 * before.mie.r);
  const glm::dvec3 left = glm::exp(-f64::optical_depth(ray.alt, ray.mu, dark.way, a));
  EXPECT_GT(left.r * rest.rayleigh.r, 0.1 * whole.rayleigh.r);
  EXPECT_LT(glm::distance(before.rayleigh + left * rest.rayleigh, whole.rayleigh), 1e-7 * whole.rayleigh.r);
}

TEST(GaussPoint, IntegratesPolynomialsUpToTheSeventhDegree) {
  for (int degree = 0; degree <= 7; ++degree) {
    double sum = 0.0;
    for (int i = 0; i < 4; ++i) sum += f64::gauss_point(i).y * std::pow(f64::gauss_point(i).x, degree);
    EXPECT_NEAR(sum, degree % 2 == 0 ? 2.0 / (degree + 1) : 0.0, 1e-15) << degree;
  }
}

}  // namespace
}  // namespace terrella
