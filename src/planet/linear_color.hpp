#pragma once

#include <glm/vec3.hpp>

#include "scene/color.hpp"

namespace terrella {

// The light of an sRGB colour, each channel 0..1.
inline glm::dvec3 linear(const Color& color) {
  return {linear_light(color.r), linear_light(color.g), linear_light(color.b)};
}

}  // namespace terrella
