// Bounds of a layer of noise are true wherever the noise they are told from was computed.
#include "reference/noise_over.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "laws/random_places.hpp"

namespace terrella {
namespace {

using reference::Directions;
using reference::KnownNoise;
using reference::noise_over;
using reference::NoiseMemory;
using reference::Range;
using test::Places;

f64::Noise noise_at(const glm::dvec3& direction, double frequency) {
  return f64::simplex_noise(glm::ivec3(0), direction * frequency, 5U);
}

// About as far away as a distance, at random.
glm::dvec3 beside(Places& places, const glm::dvec3& direction, double distance) {
  return glm::normalize(direction + distance * places.in_cube(1.0));
}

glm::dvec3 on_circle(const Directions& directions, double chord) {
  const double angle = 2.0 * std::asin(0.5 * chord);
  return std::cos(angle) * directions.middle + std::sin(angle) * *directions.along;
}

TEST(NoiseOver, HoldsAllNoiseOfCapsAndArcs) {
  Places places(41U);
  double narrowest = 10.0;
  for (int i = 0; i < 60'000; ++i) {
    const double frequency = std::pow(10.0, places.between(0.0, 6.0));
    Directions directions{places.on_sphere(), std::min(std::pow(10.0, places.between(-4.0, 0.0)) / frequency, 1.0)};
    const bool of_arc = i % 2 == 0;
    if (of_arc) directions.along = glm::normalize(glm::cross(directions.middle, places.on_sphere()));
    const double away = i % 3 == 0 ? 0.0 : std::pow(10.0, places.between(-4.0, 0.0)) / frequency;
    const glm::dvec3 from = beside(places, directions.middle, away);
    const Range range = noise_over(directions, {from, noise_at(from, frequency)}, frequency);
    narrowest = std::min(narrowest, range.most - range.least);
    for (int k = 0; k < 8; ++k) {
      const glm::dvec3 place = of_arc ? on_circle(directions, directions.chord * places.between(-1.0, 1.0))
                                      : beside(places, directions.middle, 0.55 * directions.chord);
      const double noise = noise_at(place, frequency).value;
      ASSERT_GE(noise, range.least - 1e-9) << frequency << " chord " << directions.chord << " away " << away;
      ASSERT_LE(noise, range.most + 1e-9) << frequency << " chord " << directions.chord << " away " << away;
    }
  }
  EXPECT_LT(narrowest, 1e-4);
}

// An arc across the steepest way hardly rises.
TEST(NoiseOver, OfAnArcIsNarrowerThanOfACap) {
  Places places(42U);
  double caps = 0.0, arcs = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double frequency = 100.0, chord = 1e-4;
    const glm::dvec3 middle = places.on_sphere();
    const KnownNoise known{middle, noise_at(middle, frequency)};
    const Range cap = noise_over({middle, chord}, known, frequency);
    const glm::dvec3 along = glm::normalize(glm::cross(middle, places.on_sphere()));
    const Range arc = noise_over({middle, chord, along}, known, frequency);
    EXPECT_LE(arc.most, cap.most + 1e-9);
    caps += cap.most - cap.least;
    arcs += arc.most - arc.least;
  }
  EXPECT_LT(arcs, 0.7 * caps);
}

TEST(NoiseMemory, TellsOfPlacesNearEnough) {
  NoiseMemory memory(3);
  const glm::dvec3 here(1.0, 0.0, 0.0);
  const double frequency = 10.0, chord = 1e-4;
  EXPECT_FALSE(memory.tells_of({here, chord}, 1, frequency));
  memory.keep(1, {here, noise_at(here, frequency)});
  EXPECT_FALSE(memory.tells_of({here, chord}, 0, frequency));
  EXPECT_TRUE(memory.tells_of({here, chord}, 1, frequency));
  EXPECT_TRUE(memory.tells_of({glm::normalize(here + glm::dvec3(0.0, chord, 0.0)), chord}, 1, frequency));
  EXPECT_FALSE(memory.tells_of({glm::normalize(here + glm::dvec3(0.0, 0.1, 0.0)), chord}, 1, frequency));
  EXPECT_EQ(memory.kept(), 1);
}

}  // namespace
}  // namespace terrella
