#include "planet/cloud_layers.hpp"

#include <cmath>

#include "planet/materials.hpp"

namespace terrella {

glm::dvec2 turn_of_cloud_layer(const Scene& scene, int layer, double seconds) {
  return turned(scene.clouds.speed * f64::flow_speed(layer), seconds);
}

Cyclones cyclones_of(const Scene& scene) {
  Cyclones cyclones;
  if (scene.clouds.swirl <= 0.0) return cyclones;
  for (int i = 0; i < f64::cyclone_count; ++i)
    cyclones.places.at(static_cast<std::size_t>(i)) = f64::cyclone_place(i, static_cast<unsigned>(scene.planet.seed));
  cyclones.count = f64::cyclone_count;
  return cyclones;
}

}  // namespace terrella
