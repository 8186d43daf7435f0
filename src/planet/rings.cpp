#include "planet/rings.hpp"

#include <glm/geometric.hpp>

#include "formulas/formulas.hpp"
#include "planet/pose.hpp"

namespace terrella {

bool has_rings(const Scene& scene) { return scene.rings.density > 0.0 && scene.rings.outer > scene.rings.inner; }

double rings_radius(const Scene& scene) { return has_rings(scene) ? scene.rings.outer / scene.planet.radius : 0.0; }

double ring_shade_around(const Scene& scene, const glm::dvec3& eye) {
  if (!has_rings(scene) || glm::length(eye) > top_radius(scene)) return 1.0;
  const double radius = scene.planet.radius;
  const glm::dvec3 sun = direction_of(scene.sun.latitude, scene.sun.longitude);
  return f64::ring_shade(eye, sun, scene.rings.inner / radius, scene.rings.outer / radius, scene.rings.density,
                         f64::ring_shadow_blur, static_cast<unsigned>(scene.rings.seed));
}

}  // namespace terrella
