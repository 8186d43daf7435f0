// Rays of the reference against steps so small that nothing but a slower way would find more.
#include "reference/first_hit.hpp"

#include <gtest/gtest.h>

#include <string>

#include "effort.hpp"
#include "laws/random_places.hpp"
#include "reference/ground.hpp"
#include "reference/sea.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

using reference::Ground;
using reference::Ray;
using reference::Resolution;
using reference::Span;
using test::Places;

constexpr Resolution resolution = {1e-4, 1e-6};

// A ray that passes a sphere of the given radius closely, from outside of `outer`: most of them graze the ground.
Ray grazing(Places& places, double radius, double outer) {
  const glm::dvec3 nearest = places.on_sphere();
  const glm::dvec3 along = glm::normalize(glm::cross(nearest, places.on_sphere()));
  const double start = 1.01 * std::sqrt(outer * outer - radius * radius);
  return {radius * nearest - start * along, along};
}

template <class Surface>
double height_over(const Surface& surface, const Ray& ray, double t) {
  const double radius = glm::length(ray.at(t));
  return radius - surface.radius_at(ray.at(t) / radius);
}

// The first place where a ray is under a surface that it steps upon; nothing where it stays above.
template <class Surface>
std::optional<double> stepped_hit(const Surface& surface, const Ray& ray, const Span& span, int steps) {
  for (int i = 1; i <= steps; ++i) {
    const double t = span.from + (span.to - span.from) * i / steps;
    if (height_over(surface, ray, t) <= 0.0) return t;
  }
  return std::nullopt;
}

// None of many grazing rays finds a place by small steps that the reference has passed, and where the reference finds
// one, it lies on the surface.
template <class Surface>
void expect_no_crest_missed(const Surface& surface, double lowest, double highest, int rays, int steps) {
  if (test::sanitized) rays /= 4, steps /= 4;
  Places places(91U);
  int hits = 0;
  for (int i = 0; i < rays; ++i) {
    const Ray ray = grazing(places, places.between(lowest, highest), highest);
    const std::optional<Span> shell = reference::within_sphere(ray, highest);
    ASSERT_TRUE(shell);
    const std::optional<double> found = first_hit(surface, ray, *shell, resolution);
    const std::optional<double> stepped = stepped_hit(surface, ray, *shell, steps);
    if (stepped) {
      ASSERT_TRUE(found) << "ray " << i << " passed " << *stepped;
      ASSERT_LE(*found, *stepped + std::max(resolution.least, resolution.per_distance * *stepped)) << "ray " << i;
    }
    if (!found) continue;
    ++hits;
    // Just before it the ray is above the surface and just behind it below, also where waves fold over at a shore.
    ASSERT_GT(height_over(surface, ray, *found - 1e-9), 0.0) << "ray " << i;
    ASSERT_LT(height_over(surface, ray, *found + 1e-9), 0.0) << "ray " << i;
  }
  // Otherwise nothing has been tried.
  EXPECT_GT(hits, rays / 8);
  EXPECT_LT(hits, rays);
}

Scene preset_scene(const char* name) { return find_preset(name)->scene; }

class FirstHit : public testing::TestWithParam<const char*> {};

TEST_P(FirstHit, PassesNoCrestOfTheGround) {
  const Scene scene = preset_scene(GetParam());
  const Ground ground(scene);
  expect_no_crest_missed(ground, 1.0, ground.highest(), 80, 2000);
}

INSTANTIATE_TEST_SUITE_P(Grounds, FirstHit, testing::Values("temperate", "alps", "moon", "ice", "desert"),
                         [](const auto& of) { return std::string(of.param); });

TEST(FirstHit, PassesNoCrestOfTheSea) {
  const Scene scene = preset_scene("storm");
  const Ground ground(scene);
  for (const Ground* under : {&ground, static_cast<const Ground*>(nullptr)}) {
    const reference::Sea sea(scene, 2.0, under);
    expect_no_crest_missed(sea, sea.still_radius() - 0.008, sea.still_radius() + 0.012, 20, 250);
  }
}

TEST(FirstHit, OfAFlatGroundIsThatOfTheSphere) {
  Scene scene;
  scene.terrain.height = 0.0;
  scene.water.level = 0.0;
  const Ground ground(scene);
  Places places(5U);
  for (int i = 0; i < 1000; ++i) {
    const Ray ray = {1.5 * places.on_sphere(), places.on_sphere()};
    const std::optional<Span> sphere = reference::within_sphere(ray, 1.0);
    const std::optional<double> found = ground.hit(ray, 1e9, resolution);
    ASSERT_EQ(found.has_value(), sphere && sphere->from > 0.0);
    if (found) {
      ASSERT_NEAR(*found, sphere->from, 1e-12);
    }
  }
}

// What the bound says of a cap is true of every place in it: grounds of all kinds, radii on both sides of the sphere.
TEST(GroundBound, IsTrueOfAllGrounds) {
  Places places(17U);
  const int grounds = test::sanitized ? 10 : 60;
  int below = 0;
  for (int g = 0; g < grounds; ++g) {
    Scene scene;
    scene.planet.seed = g;
    scene.water.level = g % 3 == 0 ? 0.02 : 0.0;
    auto& terrain = scene.terrain;
    terrain.height = g % 5 == 0 ? 0.0 : places.between(0.0, 0.4);
    terrain.power = g % 4 == 0 ? 0.0 : places.between(0.0, 4.0);
    terrain.octaves = g % 7;
    terrain.persistence = places.between(0.0, 1.5);
    terrain.lacunarity = places.between(1.0, 4.0);
    terrain.ridged = g % 2 == 0;
    terrain.ranges = g % 3 == 1 ? places.between(0.0, 1.0) : 0.0;
    terrain.range_layer = g % 8 == 4 ? 7 : g % 4;  // beyond all layers; where power is 0, too
    terrain.craters = g % 2 == 0 ? 1.0 : 0.0;
    terrain.crater_sizes = g % 6;
    const Ground ground(scene);
    for (int i = 0; i < 300; ++i) {
      const glm::dvec3 middle = places.on_sphere();
      const double chord = std::pow(10.0, places.between(-4.0, -0.5)), radius = places.between(0.9, 1.5);
      ASSERT_EQ(ground.reaches(middle, radius), ground.radius_at(middle) >= radius) << "ground " << g;
      if (!ground.stays_below(middle, chord, radius)) continue;
      ++below;
      for (int k = 0; k < 20; ++k) {
        const glm::dvec3 beside = glm::normalize(middle + 0.98 * chord * places.in_cube(0.577));
        ASSERT_LT(ground.radius_at(beside), radius) << "ground " << g << ", chord " << chord;
      }
    }
  }
  EXPECT_GT(below, 100);
}

}  // namespace
}  // namespace terrella
