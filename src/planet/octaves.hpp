// How many layers of noise can be seen.
#pragma once

namespace terrella {

// Of octaves layers, each lacunarity (at least 1) times as fine as the one before, those of which fewer cells than so
// many lie between two samples. frequency: of the coarsest, cells per radian; footprint: distance of samples, rad.
inline int octaves_below(double cells, double frequency, double lacunarity, int octaves, double footprint) {
  int count = 0;
  for (double f = frequency; count < octaves && f * footprint < cells; f *= lacunarity) ++count;
  return count;
}

// Those whose cells are at least two samples wide: finer ones layer_weight (shaders/lib/noise.glsl) leaves out.
inline int visible_octaves(double frequency, double lacunarity, int octaves, double footprint) {
  return octaves_below(0.5, frequency, lacunarity, octaves, footprint);
}

}  // namespace terrella
