// The light of a scene in which the sun alone shines.
#pragma once

#include "formulas/formulas.hpp"

namespace terrella::test {

// Neither air nor light from all around: what is left is the sun's.
inline f64::SceneLight bare_scene(const glm::dvec3& sun) {
  f64::SceneLight scene;
  scene.eye = {0.0, 0.0, 3.0};
  scene.eye_height = 2.0;
  scene.sun = sun;
  scene.sunlight = {2.0, 1.8, 1.5};
  scene.ambient = 0.0;
  scene.sky_glow = glm::dvec3(0.0);
  scene.air = {1.1, 0.0, 3.2, 0.22, {0.2, 0.4, 1.0}, {1.0, 0.3, 0.1}};
  return scene;
}

}  // namespace terrella::test
