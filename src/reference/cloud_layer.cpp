#include "reference/cloud_layer.hpp"

#include <glm/trigonometric.hpp>

#include "planet/materials.hpp"

namespace terrella::reference {

CloudLayer::CloudLayer(const Scene& scene, double seconds, double footprint)
    : clouds_(clouds_of(scene)),
      cyclones_(cyclones_of(scene)),
      drift_(turned(glm::radians(scene.clouds.drift), seconds)),
      footprint_(footprint),
      frequency_(scene.clouds.frequency),
      persistence_(scene.clouds.persistence),
      warp_(scene.clouds.warp),
      belts_(scene.clouds.belts),
      swirl_(f64::cyclone_turn(scene.clouds.swirl)),
      seed_(f64::cloud_seed(scene.planet.seed)) {
  for (int i = 0; i < scene.clouds.octaves; ++i) turns_.push_back(turn_of_cloud_layer(scene, i, seconds));
}

double CloudLayer::noise(const glm::dvec3& seen) const {
  const glm::dvec3 direction = f64::drifted(seen, drift_);
  glm::dvec3 wound = direction;
  for (int i = 0; i < cyclones_.count; ++i)
    wound = f64::unwound(wound, cyclones_.places.at(static_cast<std::size_t>(i)), swirl_);
  glm::dvec3 warp(0.0);
  double frequency = frequency_, amplitude = 1.0, sum = 0.0;
  int layer = 0;
  for (const glm::dvec2& turn : turns_) {
    const glm::dvec3 place = f64::flow_place(layer < f64::wound_layers ? wound : direction, frequency,
                                             f64::stirred(layer, warp_), warp, layer, seed_);
    sum += f64::flow_layer(place, amplitude * f64::layer_weight(frequency, footprint_), turn, layer, seed_, warp);
    frequency *= 2.0;
    amplitude *= persistence_;
    ++layer;
  }
  return f64::cloud_noise_of(sum, f64::amplitude_sum(persistence_, layer), belts_, direction.z);
}

f64::CloudAt CloudLayer::at(const glm::dvec3& direction, const glm::dvec3& sun) const {
  f64::CloudAt at = f64::cloud_place(direction, sun, clouds_);
  at.noise = noise(direction);
  at.rise = noise(f64::cloud_entry(at)) - at.noise;
  return at;
}

double CloudLayer::shade(const glm::dvec3& place, const glm::dvec3& sun) const {
  if (clouds_.shadow == 0.0) return 1.0;
  const double there = noise(f64::cloud_before_sun(place, sun, clouds_));
  return f64::cloud_shade(place, f64::cloud_thickness(there, clouds_.coverage, clouds_.softness), clouds_);
}

}  // namespace terrella::reference
