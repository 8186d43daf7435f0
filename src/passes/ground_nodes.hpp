// The ground as nodes of a grid, the finer, the nearer: of a quadtree on each face of a cube (Andrei, section 2), of
// the triangles of an icosahedron (Lindner), or of a grid around the place below the eye (Michelic 2018, section 3).
#pragma once

#include "gl/program_choice.hpp"
#include "gl/uniform_buffer.hpp"
#include "passes/ground.hpp"
#include "passes/node_meshes.hpp"

namespace terrella {

class GroundNodes : public GroundPass {
 public:
  void want(const Needs& needs) override;
  bool ready() override { return program_.ready(); }
  void draw(const Frame& frame) override;
  [[nodiscard]] double mirrored_climb() const override;

 private:
  gl::ProgramChoice program_{"ground/nodes"};
  gl::UniformBuffer layers_;
};

// Of a grid that stays as it is.
class GroundFixedGrid : public GroundNodes {
 public:
  explicit GroundFixedGrid(Ground technique) : technique_(technique) {}

  void update(const Frame& frame) override;
  [[nodiscard]] const NodeMeshes* nodes(GroundShown) const override { return &nodes_; }
  [[nodiscard]] bool settled() const override { return nodes_.settled(); }
  [[nodiscard]] std::int64_t noise_evaluations() const override { return nodes_.noise_evaluations(); }

 private:
  Ground technique_;
  std::shared_ptr<const NodeGrid> grid_;
  NodeMeshes nodes_;
};

}  // namespace terrella
