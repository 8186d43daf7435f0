// The lights that a planet shows at night: towns, or whatever glows there, in clusters on its habitable ground.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/scene.hpp"

namespace terrella {

struct Light {
  glm::vec3 position;  // just over the ground, planet radii
  float brightness;    // 0..1
};

struct Lights {
  std::vector<Light> lights;
  std::int64_t noise_evaluations = 0;
};

// Whether there are any to be seen.
bool has_lights(const Scene& scene);

// Found once for a ground: on land below the rock and outside of the snow, most along the shores. level: of the
// icosphere that shows the ground.
Lights find_lights(const Scene& scene, int level);

}  // namespace terrella
