#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "formulas/formulas.hpp"

namespace terrella {
namespace {

const glm::dvec3 up(0.0, 0.0, 1.0);

// Ground as a parabola over the tangent plane, and its slope.
double bent(const glm::dvec3& place) { return 0.03 * place.x - 0.2 * place.x * place.x + 0.1 * place.x * place.y; }
glm::dvec3 slope_of_bent(const glm::dvec3& place) { return {0.03 - 0.4 * place.x + 0.1 * place.y, 0.1 * place.x, 0.0}; }

// What is interpolated between three vertices knows all of ground that bends evenly, and of the sphere.
TEST(FinerGround, LiesOverTrianglesAsItBends) {
  const glm::dvec3 corners[] = {{0.1, 0.0, 0.0}, {0.0, 0.12, 0.0}, {-0.05, -0.08, 0.0}};
  const double parts[] = {0.2, 0.5, 0.3}, flat = 0.4;
  glm::dvec3 place(0.0), slope(0.0);
  double over = 0.0, square = 0.0;
  for (int i = 0; i < 3; ++i) {
    place += parts[i] * corners[i];
    slope += parts[i] * slope_of_bent(corners[i]);
    over += parts[i] * f64::over_at_vertex(flat - bent(corners[i]), slope_of_bent(corners[i]), corners[i]);
    square += parts[i] * glm::dot(corners[i], corners[i]);
  }
  EXPECT_NEAR(f64::over_between(over, slope, place), flat - bent(place), 1e-12);
  double sag = 0.0;
  for (int i = 0; i < 3; ++i) sag += parts[i] * 0.5 * glm::dot(corners[i], corners[i]);
  EXPECT_NEAR(f64::sag_between(square, place), sag - 0.5 * glm::dot(place, place), 1e-12);
}

f64::Terrain terrain() {
  f64::Terrain t{};
  t.height = 1e-3;
  t.octaves = 8;
  t.persistence = 0.5;
  t.lacunarity = 2.0;
  t.frequency = 100.0;
  t.power = 1.0;
  t.sharpness = 10.0;
  return t;
}

// A ray that comes down at an angle onto ground without layers that it lacks.
f64::FinerGround ground_under(const glm::dvec3& ray, double over, double spread = 1e-4) {
  const f64::Relief held = {0.5e-3, 1e-3, 0.0};
  return f64::held_ground(terrain(), held, f64::ray_at_mesh(ray, up, glm::dvec3(0.1, 0.0, 0.0), over), 1e-3, spread);
}

TEST(FinerGround, IsMetWhereTheRayComesDown) {
  const glm::dvec3 ray = glm::normalize(glm::dvec3(1.0, 0.0, -1.0));
  f64::FinerGround ground = ground_under(ray, 1e-5);
  f64::go_on(ground, 1.0);
  EXPECT_NEAR(ground.ray.over, 0.0, 1e-18);
  // What it has come down and what the ground has risen.
  EXPECT_NEAR(ground.ray.way * (-ray.z + 0.1 * ray.x), 1e-5, 1e-15);
  EXPECT_NEAR(f64::moved(ground).x, ground.ray.way * ray.x, 1e-18);
  EXPECT_EQ(f64::moved(ground).z, 0.0);
}

// Below it, it goes back.
TEST(FinerGround, IsMetBeforeTheMeshWhereItIsHigher) {
  f64::FinerGround ground = ground_under(glm::normalize(glm::dvec3(1.0, 0.0, -1.0)), -1e-5);
  f64::go_on(ground, 1.0);
  EXPECT_LT(ground.ray.way, 0.0);
  EXPECT_NEAR(ground.ray.over, 0.0, 1e-18);
}

// Nor does it move where the mesh knows more than the pixel.
TEST(FinerGround, IsWhereTheMeshIsThatIsAsFineAsPixels) {
  const glm::dvec3 ray = glm::normalize(glm::dvec3(1.0, 0.0, -1.0));
  f64::FinerGround ground = ground_under(ray, 1e-5, 1e-3);
  f64::add_finer_layer(ground, terrain(), 5, 3200.0, 0.03, {0.7, {1.0, -0.4, 0.2}});
  f64::go_on(ground, 1.0);
  EXPECT_EQ(ground.ray.way, 0.0);
}

// Who has no ray asks for the ground right below.
TEST(FinerGround, StaysWhereNoRayMoves) {
  f64::FinerGround ground = ground_under(glm::dvec3(0.0), 1e-5);
  f64::add_finer_layer(ground, terrain(), 5, 3200.0, 0.03, {0.7, {1.0, -0.4, 0.2}});
  f64::go_on(ground, 1.0);
  EXPECT_EQ(f64::moved(ground), glm::dvec3(0.0));
}

// Nor does it go farther than slopes are known for, which is less far where it grazes the ground or leaves it.
TEST(FinerGround, IsNotLookedForFarAway) {
  for (const double climb : {-1.0, -0.2, -0.05, 0.0, 0.3}) {
    const glm::dvec3 ray = glm::normalize(glm::dvec3(1.0, 0.0, climb - 0.1));
    f64::FinerGround ground = ground_under(ray, 1.0);
    f64::go_on(ground, 1e-4);
    EXPECT_GT(ground.ray.way, 0.0);
    EXPECT_LE(ground.ray.way, 0.5e-4 * std::max(ground.ray.closing, 0.1) + 1e-18) << climb;
  }
}

// Each layer of noise bends by that much: its slope changes so fast.
TEST(FinerGround, IsOfLayersThatBend) {
  constexpr int places = 10'000;
  constexpr double step = 1e-4;
  int within = 0;
  for (int i = 0; i < places; ++i) {
    const glm::dvec3 place(0.37 * i, 0.73 * i, 1.91 * i);
    const glm::ivec3 cell(glm::floor(place));
    const auto slope = [&](double x) {
      return 0.5 * f64::simplex_noise(cell, place - glm::dvec3(cell) + glm::dvec3(x, 0.0, 0.0), 7U).gradient.x;
    };
    if (std::abs(slope(step) - slope(-step)) <= f64::layer_bend * 2.0 * step) ++within;
  }
  EXPECT_NEAR(within, 0.9 * places, 0.02 * places);
}

// A step past hills is known as far as these bend, and a ray that has not come down to the ground has not met it.
TEST(FinerGround, IsDoubtedAsFarAsItBends) {
  const glm::dvec3 ray = glm::normalize(glm::dvec3(1.0, 0.0, -1.0));
  const f64::Noise flat = {0.0, glm::dvec3(0.0)};
  const double footprint = 1e-6;
  for (const double over : {1e-9, 3e-5}) {
    f64::FinerGround ground = ground_under(ray, over, footprint);
    EXPECT_EQ(f64::part_in_doubt(ground, footprint), over < 1e-6 ? 0.0 : 1.0);
    f64::add_finer_layer(ground, terrain(), 5, 3200.0, 0.03, flat);
    f64::go_on(ground, 1.0);
    const double all = f64::all_layers_of(terrain()), moved = glm::length(f64::moved(ground));
    const double bends = 1e-3 * 0.03 / all * f64::layer_bend * 3200.0 * 3200.0;
    EXPECT_NEAR(ground.bent, 0.5 * bends * moved * moved, 1e-12 * over) << over;
    EXPECT_EQ(f64::part_in_doubt(ground, footprint), over < 1e-6 ? 0.0 : 1.0) << over;
  }
}

// Where a ray begins once more it knows the same of what the vertices tell, and looks up the rest where it is now.
TEST(FinerGround, IsLookedForOnceMoreFromWhereTheRayEnded) {
  const glm::dvec3 ray = glm::normalize(glm::dvec3(1.0, 0.0, -1.0));
  const f64::FinerGround begun = ground_under(ray, 1e-5);
  f64::FinerGround again = f64::once_more(begun, 3e-6);
  EXPECT_EQ(f64::moved(again), 3e-6 * begun.ray.along);
  f64::go_on(again, 1.0);
  f64::FinerGround first = begun;
  f64::go_on(first, 1.0);
  EXPECT_NEAR(again.ray.way, first.ray.way, 1e-18);
  EXPECT_EQ(again.bent, 0.0);
}

// A layer's value and slope are those of the sum that it belongs to.
TEST(FinerGround, KnowsTheLayersThatAreAdded) {
  const f64::Noise noise = {0.3, {0.5, -1.0, 2.0}};
  f64::FinerGround ground = ground_under(glm::normalize(glm::dvec3(1.0, 0.0, -1.0)), 0.0);
  f64::add_finer_layer(ground, terrain(), 5, 3200.0, 0.03, noise);
  const double all = f64::all_layers_of(terrain());
  EXPECT_NEAR(ground.mean.value, 0.03 * 0.5 * 0.3 / all, 1e-15);
  EXPECT_NEAR(ground.mean.gradient.y, -0.03 * 3200.0 * 0.5 / all, 1e-12);
  EXPECT_NEAR(ground.ray.over, -1e-3 * ground.mean.value, 1e-18);
  const glm::dvec3& along = ground.ray.along;
  EXPECT_NEAR(ground.ray.closing - (0.1 * along.x - ground.ray.climb), 1e-3 * glm::dot(ground.mean.gradient, along),
              1e-15);
}

}  // namespace
}  // namespace terrella
