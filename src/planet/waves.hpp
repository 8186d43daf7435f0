// The waves of a scene's sea.
#pragma once

#include <array>
#include <vector>

#include "formulas/formulas.hpp"
#include "scene/scene.hpp"

namespace terrella {

// Of the sphere (lib/short_waves.glsl): around the positive and the negative x, y and z.
inline constexpr int regions = 6;

// A wave that is short beside the planet: each region has it from another origin.
struct RegionalWave {
  double amplitude;                    // planet radii
  double wavenumber;                   // rad per radian of arc
  double pinch;                        // Q A, planet radii
  double heading;                      // where it runs in the middle of a region, rad, clockwise from north
  std::array<double, regions> phases;  // at its origin in each region, reduced to one turn
};

// Around the whole planet: shaders/wave_block.glsl has no room for more.
inline constexpr int most_long_waves = 100;

struct Sea {
  // Those that are long beside the planet run around all of it, and so do all over a ground that is no nodes.
  std::vector<f64::Wave> waves;
  std::vector<RegionalWave> short_waves;  // longest first
  double steepness = 0.0;                 // as drawn
  bool held = false;                      // true where the asked steepness would fold the surface over
  // No crest rises higher than this over the still sea, planet radii: at short waves but for one in a thousand million.
  double highest = 0.0;
  double amplitude = 0.0;       // of one wave that is as high as all together, planet radii
  double slope_variance = 0.0;  // of all waves; of both directions together
  f64::Breaking breaking = {0.5, 0.11, 0.0};

  // Whether one of waves, or of short_waves in a region, is one of the latter.
  [[nodiscard]] bool is_short(const f64::Wave& wave) const {
    return !short_waves.empty() && wave.wavenumber >= short_waves.front().wavenumber;
  }
  [[nodiscard]] bool is_calm() const { return waves.empty() && short_waves.empty(); }
};

// The waves at a time (s, any; phases are reduced to one turn in double precision). Lengths in planet radii.
//
// Free: lengths fall from the longest to a fifth of it, heights with them, so that the root mean square height is that
// of one wave of the asked amplitude, however many there are. Speeds follow deep water: as the square root of the
// length. Wind: as wind_sea.hpp has them, over a fetch that ends at half the planet's girth. The sum of pinch times
// wavenumber stays below 1 (Michelic 8, as corrected: Q A w summed), where trochoids begin to loop; of those of a wind,
// which are so many that they never meet, six standard deviations of that sum do.
Sea make_sea(const Scene& scene, double seconds);

// Whether a wind raises the scene's waves.
bool is_of_wind(const Scene& scene);

// Whether waves, if there are any, change with time.
bool waves_run(const Scene& scene);

// How many of the waves that run around the planet are drawn.
int drawn_long_waves(const Sea& sea);

// What the short waves of a sea come to together, each with its size: where three regions meet, all have their waves
// there, but waves so many and so different never meet.
struct Together {
  double sum = 0.0, squares = 0.0;

  void add(double size) {
    sum += size;
    squares += size * size;
  }
  // Six standard deviations at the most, which one in a thousand million exceeds.
  [[nodiscard]] double most() const;
};

// The region around an axis (0..2) that a place lies next to.
int region_around(int axis, const glm::dvec3& place);

// The wave as a region (0..regions - 1) has it.
f64::Wave in_region(const RegionalWave& wave, int region);

// Length (planet radii) of the longest wave; 0 where there are none.
double longest_wave(const Sea& sea);

// Depth (planet radii) from which the ground holds waves back no longer: a few of their heights. Over a ground of nodes
// by left_ashore, which lets them run up the land; else by smoothstep(0, whole, depth), which at a depth d is at most
// 9/8 d / whole: so no trough reaches down to the ground.
double whole_wave_depth(const Sea& sea);

}  // namespace terrella
