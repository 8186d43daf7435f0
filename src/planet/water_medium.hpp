// Water by what light meets in it.
#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "scene/scene.hpp"

namespace terrella {

// Of red, green and blue light (about 610, 550 and 465 nm), 1/m.
struct WaterMedium {
  glm::dvec3 absorption;
  glm::dvec3 backscattering;  // what is scattered into the half from which it comes
};

// Nothing where the scene tells its water by a tint.
std::optional<WaterMedium> medium_of(const Scene& scene);

// What daylight loses on its way, 1/m: what is scattered ahead goes on with it.
glm::dvec3 extinction_of(const WaterMedium& medium);

// What deep water throws back of the light that falls on it: 0.33 times (Morel and Prieur 1977, "Analysis of variations
// in ocean color") the part of what is lost that is scattered back (Gordon et al. 1975).
glm::dvec3 color_of_depths(const WaterMedium& medium);

}  // namespace terrella
