#include "passes/ground_nodes.hpp"

#include <string>

#include "passes/layers.hpp"
#include "planet/node_grids.hpp"

namespace terrella {

void GroundNodes::want(const Needs& needs) {
  const char* seen_from = !needs.in_water ? "" : needs.water == Water::waves ? "_in_waves" : "_in_water";
  program_.want(std::string(needs.ground_mapped ? "ground/nodes_mapped" : "ground/nodes") + seen_from);
}

void GroundNodes::draw(const Frame& frame) {
  const LayerBlock block = layer_block(frame.scene, frame.pose, 0);
  layers_.set(gl::block_layers, std::as_bytes(std::span(&block, 1)));
  const gl::Program& program = program_.use(frame.effort == Effort::complete);
  nodes(frame.ground_shown)->draw(frame, program, frame.is_mirror ? NodeLayer::mirrored : NodeLayer::ground);
}

double GroundNodes::mirrored_climb() const { return nodes(GroundShown::now)->mirrored_climb(); }

void GroundFixedGrid::update(const Frame& frame) {
  if (!grid_) grid_ = grid_of(technique_, frame.scene, frame.pose);
  nodes_.update(frame, grid_);
}

}  // namespace terrella
