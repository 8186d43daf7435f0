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

// eye: not the planet's centre. Phases are worked out in double precision: of waves of half a metre on a planet as
// large as the Earth they are known to a hundred thousandth of a turn, after thirty years as well.
NearWaves near_waves(const Sea& sea, const glm::dvec3& eye);

// How high the water that lies over the anchor stands over the still sea, planet radii; not held by the ground.
double water_over(const NearWaves& near);

}  // namespace terrella
