// The stars of a scene: the peaks of one octave of simplex noise above a threshold (Sandahl 2022, section 2.5).
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/scene.hpp"

namespace terrella {

struct Star {
  glm::vec3 direction;  // unit
  float brightness;     // of its middle; of the brightest star: 1
  glm::vec3 color;      // linear, of about the same luminance for all
};

struct StarSky {
  std::vector<Star> stars;
  std::int64_t noise_evaluations = 0;
};

// Found once and drawn as points: a texture of the same noise would blur them when magnified and twinkle when minified.
StarSky find_stars(const Scene& scene);

}  // namespace terrella
