// How many layers of noise can be seen.
#pragma once

namespace terrella {

// Of octaves layers, each lacunarity (at least 1) times as fine as the one before, those whose cells are at least two
// samples wide; finer ones layer_weight (shaders/lib/noise.glsl) leaves out. frequency: of the coarsest, cells per
// radian; footprint: distance of samples, rad.
inline int visible_octaves(double frequency, double lacunarity, int octaves, double footprint) {
  int count = 0;
  for (double f = frequency; count < octaves && f * footprint < 0.5; f *= lacunarity) ++count;
  return count;
}

}  // namespace terrella
