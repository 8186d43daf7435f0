// All that heights of the ground depend on.
#pragma once

#include "planet/terrain.hpp"
#include "scene/scene.hpp"

namespace terrella {

struct Relief {
  decltype(Scene::planet) planet;
  decltype(Scene::terrain) terrain;
  double water_level, ice_latitude;
  bool operator==(const Relief&) const = default;
};

inline Relief relief_of(const Scene& scene) {
  return {scene.planet, scene.terrain, water_level(scene), scene.water.ice_latitude};
}

}  // namespace terrella
