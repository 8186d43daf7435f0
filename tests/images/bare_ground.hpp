// A scene of nothing but solid ground.
#pragma once

#include "scene/scene.hpp"

namespace terrella::test {

// With so few layers that pixels can show them all.
inline Scene bare_ground() {
  Scene scene;
  scene.water.model = scene.clouds.model = scene.air.model = scene.stars.model = 0;
  scene.terrain.octaves = 4;
  scene.sun.glare = scene.sun.size = 0.0;
  return scene;
}

}  // namespace terrella::test
