// The short waves of a sea as an eye has them, ready for lib/short_waves.glsl.
#pragma once

#include <array>
#include <vector>

#include "planet/waves.hpp"

namespace terrella {

struct NearWaves {
  glm::dvec3 anchor;  // unit, below the eye
  f64::Frame axes;    // there
  // Of the regions around the axes x, y and z that reach to where an eye sees waves, the longest first; none of the
  // others.
  std::array<std::vector<f64::ShortWave>, 3> waves;
};

// eye: not the planet's centre; felt_depth: as of f64::Shore. Phases are worked out in double precision: of waves of
// half a metre on a planet as large as the Earth they are known to a hundred thousandth of a turn, after thirty years
// as well.
NearWaves near_waves(const Sea& sea, const glm::dvec3& eye, double felt_depth);

// A wave as an anchor (unit) sees it, along its axes.
f64::ShortWave seen_from(const f64::Wave& wave, const glm::dvec3& anchor, const f64::Frame& axes, double felt_depth);

// All waves of a sea in the water that lies over the anchor, told along its axes; not held by the ground. shore: there.
f64::WaveSum waves_over(const Sea& sea, const NearWaves& near, const f64::Shore& shore);

}  // namespace terrella
