#include "planet/rings.hpp"

#include <glm/geometric.hpp>

#include "planet/linear_color.hpp"
#include "planet/pose.hpp"

namespace terrella {

bool has_rings(const Scene& scene) { return scene.rings.density > 0.0 && scene.rings.outer > scene.rings.inner; }

double rings_radius(const Scene& scene) { return has_rings(scene) ? scene.rings.outer / scene.planet.radius : 0.0; }

f64::Rings rings_of(const Scene& scene) {
  f64::Rings rings;
  rings.inner = scene.rings.inner / scene.planet.radius;
  rings.outer = scene.rings.outer / scene.planet.radius;
  rings.density = scene.rings.density;
  rings.color = linear(scene.rings.color);
  rings.seed = static_cast<unsigned>(scene.rings.seed);
  return rings;
}

double ring_shade_around(const Scene& scene, const glm::dvec3& eye) {
  if (!has_rings(scene) || glm::length(eye) > top_radius(scene)) return 1.0;
  const glm::dvec3 sun = direction_of(scene.sun.latitude, scene.sun.longitude);
  return f64::ring_shade(eye, sun, rings_of(scene), f64::ring_shadow_blur);
}

}  // namespace terrella
