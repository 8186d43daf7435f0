#include "passes/ground_quadtree.hpp"

#include "passes/layers.hpp"

namespace terrella {

void GroundQuadtree::draw(const Frame& frame) {
  const LayerBlock block = layer_block(frame.scene, frame.pose, 0);
  layers_.set(gl::block_layers, std::as_bytes(std::span(&block, 1)));
  program_.use();
  nodes_.draw(frame, program_, NodeMeshes::Layer::ground);
}

}  // namespace terrella
