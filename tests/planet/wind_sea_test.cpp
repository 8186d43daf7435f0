#include "planet/wind_sea.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace terrella {
namespace {

double variance_between(const WindSpectrum& spectrum, double from, double to) {
  constexpr int steps = 20'000;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double frequency = from * std::pow(to / from, (i + 0.5) / steps);
    sum += spectrum.density(frequency) * frequency * std::log(to / from) / steps;
  }
  return sum;
}

double variance_of(const std::vector<WindWave>& waves) {
  double sum = 0.0;
  for (const WindWave& wave : waves) sum += 0.5 * wave.amplitude * wave.amplitude;
  return sum;
}

TEST(WindSpectrum, IsHighestAtItsPeak) {
  for (const double wind : {0.5, 3.0, 10.0, 40.0}) {
    for (const double fetch : {10.0, 1e4, 1e6}) {
      const WindSpectrum spectrum(wind, fetch);
      const double top = spectrum.density(spectrum.peak());
      for (double part = 0.5; part < 3.0; part += 0.01)
        ASSERT_LE(spectrum.density(part * spectrum.peak()), 1.001 * top) << wind << ' ' << fetch << ' ' << part;
    }
  }
}

// By the spectrum's own exponents the energy grows as the fetch to the power of 4/3 - 0.22; a sea that is fully
// developed has waves of about a quarter of U^2/g (Pierson and Moskowitz 1964: 0.21; JONSWAP's peak adds to that).
TEST(WindSpectrum, GrowsWithFetchUntilItIsFullyDeveloped) {
  const auto height = [](double wind, double fetch) {  // significant
    return 4.0 * std::sqrt(variance_between(WindSpectrum(wind, fetch), 0.05, 60.0));
  };
  EXPECT_NEAR(height(10.0, 4e4) / height(10.0, 1e4), std::pow(4.0, 0.5 * (4.0 / 3.0 - 0.22)), 0.01);
  EXPECT_NEAR(height(10.0, 1e5), 2.14, 0.02);
  EXPECT_NEAR(height(10.0, 1e8) / (100.0 / gravity), 0.27, 0.01);
  EXPECT_EQ(height(10.0, 1e8), height(10.0, 1e7));
  EXPECT_GT(height(20.0, 1e5), 1.8 * height(10.0, 1e5));
}

TEST(WindWaves, HaveTheEnergyOfTheirRangeHoweverMany) {
  const WindSpectrum spectrum(9.0, 2e5);
  const double shortest = 0.3;
  const double all = variance_between(spectrum, 0.7 * spectrum.peak(), deep_frequency(shortest));
  for (const std::size_t count : {1, 2, 7, 60, 1000}) {
    for (const double jitter : {0.0, 0.3, 0.99}) {
      const auto waves = wind_waves(spectrum, shortest, std::vector<double>(count, jitter));
      ASSERT_EQ(waves.size(), count);
      EXPECT_NEAR(variance_of(waves), all, 1e-3 * all) << count;
      for (std::size_t i = 1; i < count; ++i) ASSERT_LT(waves[i].length, waves[i - 1].length);
      EXPECT_GE(waves.back().length, 0.999 * shortest);
      EXPECT_LE(waves.front().length, 1.001 * deep_length(0.7 * spectrum.peak()));
    }
  }
}

// Half of the waves by octaves, half by energy: as many are there for the swell as for what glitters.
TEST(WindWaves, AreOfAllLengths) {
  const WindSpectrum spectrum(9.0, 2e5);
  const auto waves = wind_waves(spectrum, 0.3, std::vector<double>(100, 0.5));
  const auto shorter = [&](double length) {
    return std::count_if(waves.begin(), waves.end(), [&](const WindWave& wave) { return wave.length < length; });
  };
  EXPECT_GE(shorter(1.0), 6);
  EXPECT_GE(shorter(5.0) - shorter(1.0), 10);
  EXPECT_GE(100 - shorter(0.5 * deep_length(spectrum.peak())), 45);
}

TEST(WindWaves, KeepThePeakWhereTheShortestIsLonger) {
  const WindSpectrum spectrum(1.0, 10.0);  // ripples on a pond
  const auto waves = wind_waves(spectrum, 50.0, std::vector<double>(5, 0.5));
  EXPECT_GT(variance_of(waves), 0.0);
  EXPECT_LT(waves.front().length, 1.0);
}

TEST(DeepWater, LengthsAndFrequenciesAreInverse) {
  for (double length = 0.003; length < 2000.0; length *= 1.3)
    EXPECT_NEAR(deep_length(deep_frequency(length)), length, 1e-9 * length);
  const double k = 2.0 * std::numbers::pi / 100.0;
  EXPECT_NEAR(deep_frequency(100.0), std::sqrt(gravity * k), 1e-6);
}

// Of all waves on water, those of 1.7 cm are the slowest, at 23 cm/s (Lamb, Hydrodynamics, 267).
TEST(DeepWater, HasASlowestWave) {
  double least = 1.0, at = 0.0;
  for (double length = 0.005; length < 0.1; length += 1e-5) {
    const double speed = deep_frequency(length) * length / (2.0 * std::numbers::pi);
    if (speed < least) {
      least = speed;
      at = length;
    }
  }
  EXPECT_NEAR(least, 0.231, 0.002);
  EXPECT_NEAR(at, 0.0171, 0.0003);
}

TEST(NormalDistribution, DeviationsAreTheInverseOfParts) {
  for (double deviations = -5.0; deviations <= 5.0; deviations += 0.01)
    EXPECT_NEAR(deviations_of(0.5 * std::erfc(-deviations / std::numbers::sqrt2)), deviations, 5e-4);
}

TEST(Directions, AreSpreadAsTheSquaredCosine) {
  constexpr int count = 10'000;
  double cosines = 0.0, sum = 0.0;
  for (int i = 0; i < count; ++i) {
    const double angle = angle_of_part((i + 0.5) / count);
    EXPECT_LE(std::abs(angle), 0.5 * std::numbers::pi);
    cosines += std::pow(std::cos(angle), 2) / count;
    sum += angle / count;
  }
  EXPECT_NEAR(cosines, 0.75, 1e-3);  // the mean of cos^2 weighted by itself
  EXPECT_NEAR(sum, 0.0, 1e-6);
}

TEST(Whitecaps, CoverMoreInStrongerWind) {
  EXPECT_NEAR(whitecaps(10.0), 0.01, 0.001);
  EXPECT_LT(whitecaps(3.0), 2e-4);
  EXPECT_EQ(whitecaps(60.0), 0.3);
}

}  // namespace
}  // namespace terrella
