// The waves that a wind raises: a standard spectrum, and a given number of waves that have its energy. SI units.
#pragma once

#include <vector>

namespace terrella {

// Standard gravity, m/s^2.
inline constexpr double gravity = 9.80665;

// JONSWAP (Hasselmann et al. 1973) with its mean peak enhancement, up to the fetch at which the sea is fully developed
// (Pierson and Moskowitz 1964).
class WindSpectrum {
 public:
  // wind: m/s, 10 m over the sea, > 0; fetch: m, > 0.
  WindSpectrum(double wind, double fetch);

  // Angular frequency at which it is highest, rad/s.
  [[nodiscard]] double peak() const { return peak_; }
  // Variance of the height per angular frequency, m^2 s. frequency: rad/s, > 0.
  [[nodiscard]] double density(double frequency) const;

 private:
  double peak_, alpha_;
};

// Angular frequency (rad/s) of deep water's waves of a length (m, > 0), with the surface's tension, which drives those
// below some centimetres.
double deep_frequency(double length);
// The length (m) of deep water's waves of an angular frequency (rad/s, > 0); the inverse of the above.
double deep_length(double frequency);

struct WindWave {
  double length;     // m
  double amplitude;  // m
};

// count waves, the longest first: between the lengths of 0.7 of the peak's frequency and the shortest (m, > 0; held to
// the peak's length) the spectrum is divided into as many parts, half of them by energy and half by octaves, so that
// few waves have a swell's height and many the small waves that glitter. Each wave has all the energy of its part: the
// sum of half the squared amplitudes is the variance of that range. jitter: of each wave, 0..1: where in its part it
// lies.
std::vector<WindWave> wind_waves(const WindSpectrum& spectrum, double shortest, const std::vector<double>& jitter);

// Part of the sea that breakers whiten in a wind (m/s): Monahan and O'Muircheartaigh 1980; no more than 0.3.
double whitecaps(double wind);

// By how many standard deviations a part (0..1, exclusive) of a normal distribution lies below: the inverse of its
// cumulated density, within 5e-4.
double deviations_of(double part);

// The angle (rad) below which a part (0..1) of waves runs, of which as many as the squared cosine says run at an angle
// to the wind: within a quarter turn to each side.
double angle_of_part(double part);

}  // namespace terrella
