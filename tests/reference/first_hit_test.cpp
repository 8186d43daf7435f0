// Rays of the reference against steps so small that nothing but a slower way would find more.
#include "reference/first_hit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "effort.hpp"
#include "laws/random_places.hpp"
#include "planet/terrain.hpp"
#include "reference/ground_on_ray.hpp"
#include "reference/sea.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

using reference::Directions;
using reference::Ground;
using reference::GroundOnRay;
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
  expect_no_crest_missed(GroundOnRay(ground), 1.0, ground.highest(), 80, 2000, anywhere);
}

INSTANTIATE_TEST_SUITE_P(Grounds, FirstHit, testing::Values("temperate", "alps", "moon", "ice", "desert"),
                         [](const auto& of) { return std::string(of.param); });

// On a planet of real size, where floes are as wide as its mountains are long, among them and over them.
TEST(FirstHit, PassesNoFloe) {
  const Scene scene = preset_scene("blue");
  const Ground ground(scene);
  expect_no_crest_missed(GroundOnRay(ground), 0.999, ground.highest(), 60, 2000, polar);
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

// A ground that counts how often it is asked about a piece of a ray, and how often noise is computed for that.
struct Counted {
  const Ground& ground;
  mutable reference::NoiseMemory memory = ground.no_memory();
  mutable int pieces = 0;

  [[nodiscard]] double radius_at(const glm::dvec3& direction) const { return ground.radius_at(direction); }
  [[nodiscard]] bool reaches(const glm::dvec3& direction, double radius) const {
    return ground.reaches(direction, radius);
  }
  [[nodiscard]] bool stays_below(const Directions& directions, double radius) const {
    ++pieces;
    return ground.stays_below(directions, radius, memory);
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

// From a man's height on, over all layers of planets of real size: a piece asks for those alone that are about as fine
// as it is long, and not again for all that are coarser. Layers too fine for numbers leave no doubt that no piece
// clears.
TEST(FirstHit, ComputesFewLayersAPieceAndFewPieces) {
  for (const char* preset : {"blue", "giant"}) {
    const Scene scene = preset_scene(preset);
    const Ground ground(scene);
    const Counted counted{ground};
    Places places(24U);
    constexpr int rays = 200;
    for (int i = 0; i < rays; ++i) {
      const glm::dvec3 up = places.on_sphere();
      const double height = 2.0 / scene.planet.radius;
      const glm::dvec3 level = glm::normalize(glm::cross(up, places.on_sphere()));
      const Ray ray = {(ground.radius_at(up) + height) * up, glm::normalize(level + places.between(-0.5, 0.1) * up)};
      first_hit(counted, ray, {0.0, 0.02}, {1e-4, 1e-4 * height});
    }
    EXPECT_LT(static_cast<double>(counted.memory.kept()) / counted.pieces, 4.5) << preset;
    EXPECT_LT(counted.pieces, 80 * rays) << preset;
  }
}

// A ground of any kind. number: what kind, and its seed.
Scene some_ground(Places& places, int number) {
  Scene scene;
  scene.planet.seed = number;
  scene.water.level = number % 3 == 0 ? 0.02 : 0.0;
  scene.water.ice_latitude = number % 2 == 0 ? places.between(0.0, 90.0) : 90.0;
  auto& terrain = scene.terrain;
  terrain.height = number % 5 == 0 ? 0.0 : places.between(0.0, 0.4);
  terrain.power = number % 4 == 0 ? 0.0 : places.between(0.0, 4.0);
  terrain.octaves = number % 7;
  terrain.persistence = places.between(0.0, 1.5);
  terrain.lacunarity = places.between(1.0, 4.0);
  terrain.ridged = number % 2 == 0;
  terrain.ranges = number % 3 == 1 ? places.between(0.0, 1.0) : 0.0;
  terrain.foothills = number % 2 == 0 ? places.between(0.0, 1.0) : 0.0;
  terrain.range_layer = number % 8 == 4 ? 7 : number % 4;  // beyond all layers; where power is 0, too
  terrain.craters = number % 2 == 0 ? 1.0 : 0.0;
  terrain.crater_sizes = number % 6;
  return scene;
}

// Any of some directions.
glm::dvec3 one_of(Places& places, const Directions& directions) {
  const double chord = 0.98 * directions.chord;
  if (!directions.along) return glm::normalize(directions.middle + chord * places.in_cube(0.577));
  const double angle = 2.0 * std::asin(0.5 * places.between(-chord, chord));
  return std::cos(angle) * directions.middle + std::sin(angle) * *directions.along;
}

// What the bound says of directions is true of each of them: of caps and of arcs, on grounds of all kinds, at radii on
// both sides of the sphere.
TEST(GroundBound, IsTrueOfAllGrounds) {
  Places places(17U);
  const int grounds = test::sanitized ? 10 : 60;
  int below = 0;
  for (int g = 0; g < grounds; ++g) {
    const double footprint =
        g % 4 == 1 || g % 4 == 2 ? std::pow(10.0, places.between(-2.5, -0.5)) : 0.0;  // hides layers and craters
    const Ground ground(some_ground(places, g), footprint);
    const GroundOnRay on_ray(ground);
    for (int i = 0; i < 300; ++i) {
      Directions directions{places.on_sphere(), std::pow(10.0, places.between(-4.0, -0.5))};
      if (i % 2 == 0) directions.along = glm::normalize(glm::cross(directions.middle, places.on_sphere()));
      const double radius = places.between(0.9, 1.5);
      ASSERT_EQ(ground.reaches(directions.middle, radius), ground.radius_at(directions.middle) >= radius);
      const reference::Range range = ground.heights_over(directions, {radius - 1.0, radius - 1.0});
      const bool stays_below = on_ray.stays_below(directions, radius);
      if (stays_below) ++below;
      for (int k = 0; k < 20; ++k) {
        const double there = ground.radius_at(one_of(places, directions));
        ASSERT_GE(there, 1.0 + range.least - 1e-12) << "ground " << g << ", chord " << directions.chord;
        ASSERT_LE(there, 1.0 + range.most + 1e-12) << "ground " << g << ", chord " << directions.chord;
        if (stays_below) {
          ASSERT_LT(there, radius) << "ground " << g << ", chord " << directions.chord;
        }
      }
    }
  }
  EXPECT_GT(below, 100);
}

// Nor does it matter where the layers have been computed that it is told from: along a ray they are kept from piece to
// piece.
TEST(GroundBound, IsTrueWithLayersKeptFromOtherPlaces) {
  Places places(18U);
  const int grounds = test::sanitized ? 10 : 60;
  long computed = 0, asked = 0;
  for (int g = 0; g < grounds; ++g) {
    Scene scene = g % 6 == 5 ? preset_scene(g % 12 == 5 ? "blue" : "highlands") : some_ground(places, g);
    const Ground ground(scene);
    for (int walk = 0; walk < 10; ++walk) {
      reference::NoiseMemory memory = ground.no_memory();
      glm::dvec3 middle = places.on_sphere();
      for (double chord = 0.1; chord > 1e-7; chord *= places.between(0.4, 1.0)) {
        Directions directions{middle, chord};
        if (walk % 2 == 0) directions.along = glm::normalize(glm::cross(middle, places.on_sphere()));
        const double near = ground.height_at(middle).value + chord * places.between(-1.0, 1.0);
        const reference::Range range = ground.heights_over(directions, {near, near}, memory);
        asked += scene.terrain.octaves;
        for (int k = 0; k < 10; ++k) {
          const double there = ground.height_at(one_of(places, directions)).value;
          ASSERT_GE(there, range.least - 1e-13) << "ground " << g << ", chord " << chord;
          ASSERT_LE(there, range.most + 1e-13) << "ground " << g << ", chord " << chord;
        }
        middle = one_of(places, directions);
      }
      computed += memory.kept();
    }
  }
  // Otherwise nothing has been kept.
  EXPECT_LT(computed, asked / 2);
}

}  // namespace
}  // namespace terrella
