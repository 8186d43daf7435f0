// Rays of the reference against steps so small that nothing but a slower way would find more.
#include "reference/first_hit.hpp"

#include <gtest/gtest.h>

#include <string>

#include "effort.hpp"
#include "laws/random_places.hpp"
#include "planet/terrain.hpp"
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

// A ray that passes a sphere of the given radius closely, nearest to it in the given direction, from outside of
// `outer`: most of them graze the ground.
Ray grazing(Places& places, const glm::dvec3& nearest, double radius, double outer) {
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
// one, it lies on the surface. somewhere: says where a ray is nearest to the planet.
template <class Surface, class Somewhere>
void expect_no_crest_missed(const Surface& surface, double lowest, double highest, int rays, int steps,
                            const Somewhere& somewhere) {
  if (test::sanitized) rays /= 4, steps /= 4;
  Places places(91U);
  int hits = 0;
  for (int i = 0; i < rays; ++i) {
    const Ray ray = grazing(places, somewhere(places), places.between(lowest, highest), highest);
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

glm::dvec3 anywhere(Places& places) { return places.on_sphere(); }

glm::dvec3 polar(Places& places) { return glm::normalize(glm::dvec3(0.0, 0.0, 1.0) + places.in_cube(0.25)); }

Scene preset_scene(const char* name) { return find_preset(name)->scene; }

class FirstHit : public testing::TestWithParam<const char*> {};

TEST_P(FirstHit, PassesNoCrestOfTheGround) {
  const Scene scene = preset_scene(GetParam());
  const Ground ground(scene);
  expect_no_crest_missed(ground, 1.0, ground.highest(), 80, 2000, anywhere);
}

INSTANTIATE_TEST_SUITE_P(Grounds, FirstHit, testing::Values("temperate", "alps", "moon", "ice", "desert"),
                         [](const auto& of) { return std::string(of.param); });

// On a planet of real size, where floes are as wide as its mountains are long, among them and over them.
TEST(FirstHit, PassesNoFloe) {
  const Scene scene = preset_scene("blue");
  const Ground ground(scene);
  expect_no_crest_missed(ground, 0.999, ground.highest(), 60, 2000, polar);
}

TEST(FirstHit, PassesNoCrestOfTheSea) {
  const Scene scene = preset_scene("storm");
  const Ground ground(scene);
  for (const Ground* under : {&ground, static_cast<const Ground*>(nullptr)}) {
    const reference::Sea sea(scene, 2.0, under);
    expect_no_crest_missed(sea, sea.still_radius() - 0.008, sea.still_radius() + 0.012, 20, 250, anywhere);
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

// A ground that counts how often it is asked about a piece of a ray.
struct Counted {
  const Ground& ground;
  mutable int pieces = 0;

  [[nodiscard]] double radius_at(const glm::dvec3& direction) const { return ground.radius_at(direction); }
  [[nodiscard]] bool reaches(const glm::dvec3& direction, double radius) const {
    return ground.reaches(direction, radius);
  }
  [[nodiscard]] bool stays_below(const glm::dvec3& direction, double chord, double radius) const {
    ++pieces;
    return ground.stays_below(direction, chord, radius);
  }
};

// How many pieces are looked at of a ray, in the mean of those from eyes over the ice and the open water around a pole
// of a planet of real size. finest: as of Resolution, per distance.
double pieces_over_the_pole(double finest) {
  const Scene scene = preset_scene("blue");
  const Ground ground(scene);
  const Counted counted{ground};
  const double radius = scene.planet.radius, altitude = 20e3 / radius, sea = 1.0 + water_level(scene) / radius;
  Places places(23U);
  constexpr int rays = 400;
  for (int i = 0; i < rays; ++i) {
    const glm::dvec3 up = polar(places);
    const Ray ray = {(1.0 + altitude) * up, glm::normalize(places.in_cube(0.9) - up)};
    const std::optional<double> water = reference::meets_sphere(ray, sea);
    if (water) first_hit(counted, ray, {0.0, *water}, {finest, finest * altitude});
  }
  return static_cast<double>(counted.pieces) / rays;
}

// Where there may be ice, a ray is not looked at in pieces as short as pixels all the way down from its height.
TEST(FirstHit, TakesHardlyLongerForFinerPictures) {
  const double coarse = pieces_over_the_pole(1e-2), fine = pieces_over_the_pole(1e-4);
  EXPECT_LT(coarse, 15.0);
  EXPECT_LT(fine, 2.5 * coarse);
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
    scene.water.ice_latitude = g % 2 == 0 ? places.between(0.0, 90.0) : 90.0;
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
      const reference::Range range = ground.range_around(middle, chord, {radius - 1.0, radius - 1.0});
      const bool stays_below = ground.stays_below(middle, chord, radius);
      if (stays_below) ++below;
      for (int k = 0; k < 20; ++k) {
        const glm::dvec3 beside = glm::normalize(middle + 0.98 * chord * places.in_cube(0.577));
        const double there = ground.radius_at(beside);
        ASSERT_GE(there, 1.0 + range.least - 1e-12) << "ground " << g << ", chord " << chord;
        ASSERT_LE(there, 1.0 + range.most + 1e-12) << "ground " << g << ", chord " << chord;
        if (stays_below) {
          ASSERT_LT(there, radius) << "ground " << g << ", chord " << chord;
        }
      }
    }
  }
  EXPECT_GT(below, 100);
}

}  // namespace
}  // namespace terrella
