// The rings of a scene. Lengths in planet radii.
#pragma once

#include <glm/vec3.hpp>

#include "formulas/formulas.hpp"
#include "scene/scene.hpp"

namespace terrella {

// Whether the scene asks for rings that can be seen.
bool has_rings(const Scene& scene);

// At which they end; 0 without rings.
double rings_radius(const Scene& scene);

f64::Rings rings_of(const Scene& scene);

// Part of the sunlight that they leave at the eye and all around it where it is not above all that
// they shade (top_radius); 1 above.
double ring_shade_around(const Scene& scene, const glm::dvec3& eye);

}  // namespace terrella
