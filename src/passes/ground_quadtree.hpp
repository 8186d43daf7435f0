// The ground as nodes of a quadtree on each face of a cube (Andrei, section 2): the finer, the nearer.
#pragma once

#include "gl/program.hpp"
#include "gl/uniform_buffer.hpp"
#include "passes/ground.hpp"
#include "passes/node_meshes.hpp"

namespace terrella {

class GroundQuadtree : public GroundPass {
 public:
  bool ready() override { return program_.ready(); }
  void update(const Frame& frame) override { nodes_.update(frame); }
  void draw(const Frame& frame) override;
  [[nodiscard]] const NodeMeshes* nodes() const override { return &nodes_; }
  [[nodiscard]] bool settled() const override { return nodes_.settled(); }
  [[nodiscard]] std::int64_t noise_evaluations() const override { return nodes_.noise_evaluations(); }

 private:
  gl::Program program_{"ground/nodes"};
  gl::UniformBuffer layers_;
  NodeMeshes nodes_;
};

}  // namespace terrella
