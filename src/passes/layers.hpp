// The layers of the ground's noise as told from a place near the eye.
#pragma once

#include <array>

#include <glm/vec4.hpp>

#include "planet/pose.hpp"
#include "scene/scene.hpp"

namespace terrella {

inline constexpr int most_layers = 32;

// As in shaders/layer_block.glsl, std140.
struct LayerBlock {
  glm::vec4 anchor;
  std::array<glm::ivec4, most_layers> cell;
  std::array<glm::vec4, most_layers> place;
};

// first: the layer that pixels begin with.
LayerBlock layer_block(const Scene& scene, const Pose& pose, int first);

}  // namespace terrella
