// A terrain of hills, without ranges, craters and ice.
#pragma once

#include "formulas/formulas.hpp"

namespace terrella::test {

inline f64::Terrain hills() {
  f64::Terrain t;
  t.height = 0.15;
  t.frequency = 1.3;
  t.octaves = 8;
  t.persistence = 0.5;
  t.lacunarity = 2.03;
  t.power = 2.1;
  t.ridged = false;
  t.sharpness = 14.0;
  t.ranges = {0.0, 0, 0.0};
  t.seed = 3U;
  t.craters.depth = 0.0;
  t.craters.frequency = 3.0;
  t.craters.sizes = 5;
  t.craters.seed = 3U;
  t.ice.sea = 0.0;
  t.ice.sine = 2.0;
  t.ice.thickness = 0.0012;
  t.ice.seed = 3U;
  return t;
}

}  // namespace terrella::test
