#include "planet/wind_sea.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace terrella {
namespace {

constexpr double whole_turn = 2.0 * std::numbers::pi;

// Surface tension over density of water, m^3/s^2.
constexpr double tension = 7.3e-5;

// The inverse of a function that rises from one end of a span to the other.
template <class Function>
double where_it_is(double value, double from, double to, const Function& rising) {
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (from + to);
    (rising(middle) < value ? from : to) = middle;
  }
  return 0.5 * (from + to);
}

// Energy of a spectrum up to frequencies that are even steps of their logarithm apart.
struct Energies {
  std::vector<double> logarithms, sums;
};

Energies energies_between(const WindSpectrum& spectrum, double lowest, double highest) {
  constexpr int steps = 512;
  Energies energies;
  const double from = std::log(lowest), step = (std::log(highest) - from) / steps;
  double sum = 0.0, before = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const double logarithm = from + i * step, frequency = std::exp(logarithm);
    const double now = spectrum.density(frequency) * frequency;
    if (i > 0) sum += 0.5 * (before + now) * step;
    before = now;
    energies.logarithms.push_back(logarithm);
    energies.sums.push_back(sum);
  }
  return energies;
}

}  // namespace

WindSpectrum::WindSpectrum(double wind, double fetch) {
  // Fetches as Hasselmann et al. count them, in units of the wind's own length; from the longest on the peak is that of
  // a sea that grows no more.
  constexpr double longest = 1.58e4;
  const double fetches = std::min(gravity * fetch / (wind * wind), longest);
  peak_ = 22.0 * gravity / wind * std::pow(fetches, -1.0 / 3.0);
  alpha_ = 0.076 * std::pow(fetches, -0.22);
}

double WindSpectrum::density(double frequency) const {
  constexpr double enhancement = 3.3;
  const double over_peak = frequency / peak_;
  const double away = (over_peak - 1.0) / (over_peak <= 1.0 ? 0.07 : 0.09);
  const double inverse = 1.0 / std::pow(over_peak, 4);
  return alpha_ * gravity * gravity / std::pow(frequency, 5) * std::exp(-1.25 * inverse) *
         std::pow(enhancement, std::exp(-0.5 * away * away));
}

double deep_frequency(double length) {
  const double k = whole_turn / length;
  return std::sqrt((gravity + tension * k * k) * k);
}

double deep_length(double frequency) {
  // Newton's method from without tension, where the function curves up: it comes down from above.
  const double square = frequency * frequency;
  double k = std::min(square / gravity, std::pow(square / tension, 1.0 / 3.0));
  for (int i = 0; i < 20; ++i) k -= (gravity * k + tension * k * k * k - square) / (gravity + 3.0 * tension * k * k);
  return whole_turn / k;
}

std::vector<WindWave> wind_waves(const WindSpectrum& spectrum, double shortest, const std::vector<double>& jitter) {
  const double lowest = 0.7 * spectrum.peak();
  const double highest = deep_frequency(std::min(shortest, deep_length(spectrum.peak())));
  const Energies energies = energies_between(spectrum, lowest, highest);
  const std::vector<double>&logarithms = energies.logarithms, &sums = energies.sums;
  const auto share = [&, octaves = logarithms.back() - logarithms.front()](std::size_t i) {
    return 0.5 * sums[i] / sums.back() + 0.5 * (logarithms[i] - logarithms.front()) / octaves;
  };
  // The place, in steps, up to which a part of all waves lies; steps are passed once.
  std::size_t step = 0;
  const auto place_of = [&](double part) {
    while (step + 2 < sums.size() && share(step + 1) < part) ++step;
    const double from = share(step), to = share(step + 1);
    return static_cast<double>(step) + std::clamp((part - from) / (to - from), 0.0, 1.0);
  };
  const auto between = [](const std::vector<double>& values, double place) {
    const auto before = std::min(static_cast<std::size_t>(place), values.size() - 2);
    const double part = place - static_cast<double>(before);
    return values[before] + part * (values[before + 1] - values[before]);
  };
  std::vector<WindWave> waves;
  const auto count = static_cast<double>(jitter.size());
  double from = 0.0;
  for (std::size_t i = 0; i < jitter.size(); ++i) {
    const auto rank = static_cast<double>(i);
    const double at = place_of((rank + jitter[i]) / count);
    const double to = i + 1 < jitter.size() ? place_of((rank + 1.0) / count) : static_cast<double>(sums.size() - 1);
    const double energy = between(sums, to) - between(sums, from);
    waves.push_back({deep_length(std::exp(between(logarithms, at))), std::sqrt(2.0 * std::max(energy, 0.0))});
    from = to;
  }
  return waves;
}

double whitecaps(double wind) { return std::min(3.84e-6 * std::pow(wind, 3.41), 0.3); }

// Hastings' approximation (Abramowitz and Stegun 26.2.23).
double deviations_of(double part) {
  const double t = std::sqrt(-2.0 * std::log(std::min(part, 1.0 - part)));
  const double size =
      t - (2.515517 + t * (0.802853 + t * 0.010328)) / (1.0 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
  return part < 0.5 ? -size : size;
}

double angle_of_part(double part) {
  constexpr double quarter = 0.5 * std::numbers::pi;
  return where_it_is(part, -quarter, quarter,
                     [](double angle) { return 0.5 + (angle + std::sin(angle) * std::cos(angle)) / std::numbers::pi; });
}

}  // namespace terrella
