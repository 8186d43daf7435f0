// The waves of a scene's sea.
#pragma once

#include <vector>

#include "formulas/formulas.hpp"
#include "scene/scene.hpp"

namespace terrella {

struct Sea {
  std::vector<f64::Wave> waves;  // longest first
  double steepness = 0.0;        // as drawn
  bool held = false;             // true where the asked steepness would fold the surface over
  double highest = 0.0;          // no crest rises higher than this over the still sea, planet radii
};

// The waves at a time (s, any; phases are reduced to one turn in double precision). Lengths in planet radii.
//
// Lengths fall from the longest to a fifth of it, heights with them, so that the root mean square height is that of one
// wave of the asked amplitude, however many there are. Speeds follow deep water: as the square root of the length. The
// sum of pinch times wavenumber stays below 1 (Michelic 8, as corrected: Q A w summed), where trochoids begin to loop.
Sea make_sea(const Scene& scene, double seconds);

// Depth (planet radii) from which waves no longer feel the ground: a few of their heights, and so deep that at a place
// of less depth no trough reaches down to the ground. Waves are held by smoothstep(0, whole, depth), which at a depth d
// is at most 9/8 d / whole.
double whole_wave_depth(const Scene& scene, const Sea& sea);

}  // namespace terrella
