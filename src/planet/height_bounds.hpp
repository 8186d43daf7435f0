// Between which heights the ground lies where only some of them have been computed. Lengths in planet radii.
#pragma once

#include "formulas/formulas.hpp"

namespace terrella {

// Heights over the unit sphere.
struct HeightRange {
  double lowest = 0.0, highest = 0.0;
};

// The range of the whole ground within `apart` (rad) of places whose heights were computed, for samples a footprint
// (rad) apart, and lie within `computed`. Told from how steep its layers can be and how strong those are that the
// samples left out; never too narrow, and wider than the truth by about as much as hills of the size of `apart` are
// high.
// may_freeze: whether ice may lie between those places.
HeightRange heights_around(const f64::Terrain& terrain, const HeightRange& computed, double footprint, double apart,
                           bool may_freeze);

// Whether ice may lie within a distance (rad) of a direction (unit).
bool may_freeze(const f64::Ice& ice, const glm::dvec3& direction, double distance);

}  // namespace terrella
