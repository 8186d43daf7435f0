// Between which heights the ice around the poles lies (shaders/lib/ice.glsl). Lengths in planet radii.
#pragma once

#include <glm/vec3.hpp>

#include "formulas/formulas.hpp"
#include "reference/range.hpp"

namespace terrella::reference {

// Bounds of ice_height, over the unit sphere, of all directions within chord of a direction (unit), for samples a
// footprint (rad) apart. No wider than what a place's distance from the rim of its floe can change within chord; from
// half a floe on, as wide as all ice.
Range ice_around(const f64::Ice& ice, const glm::dvec3& direction, double chord, double footprint);

}  // namespace terrella::reference
