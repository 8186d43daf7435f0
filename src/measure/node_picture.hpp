// The nodes that a picture of a ground is drawn with, chosen and made on the CPU alone as NodeMeshes does for the GPU.
// Lengths in planet radii.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "measure/pixel_ground.hpp"
#include "planet/node_layers.hpp"
#include "planet/node_mesh.hpp"

namespace terrella {

class NodePicture {
 public:
  // Makes all that the picture needs, as far as there is room for it. scene: with a ground of nodes.
  NodePicture(const Scene& scene, const View& view);

  // What is done in every frame: measures how near the ground is, and chooses.
  void look();
  void choose();

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const View& view() const { return view_; }
  [[nodiscard]] const Pose& pose() const { return pose_; }
  [[nodiscard]] const Needs& needs() const { return needs_; }
  [[nodiscard]] const f64::Terrain& terrain() const { return terrain_; }
  [[nodiscard]] const NodePatch& patch() const { return patch_; }
  [[nodiscard]] const NodeRanges& ranges() const { return ranges_; }

  // The nearest first.
  [[nodiscard]] std::span<const DrawnNode> drawn() const { return choice_.drawn; }
  // Left out because nearer ones hide them.
  [[nodiscard]] std::vector<DrawnNode> hidden() const;
  [[nodiscard]] bool shows(NodeLayer layer, const DrawnNode& drawn) const;
  // How far each vertex has taken on the shape of the level above, 0..1.
  [[nodiscard]] std::vector<double> coarse_parts_of(const DrawnNode& drawn) const;
  // Where the vertices of a node lie, those of its skirt left out.
  [[nodiscard]] std::vector<glm::dvec3> vertices_of(const DrawnNode& drawn) const;
  // The same vertices, and what else they tell.
  [[nodiscard]] std::vector<ToldGround> told_by(const DrawnNode& drawn) const;
  // Three vertices a triangle.
  enum class Skirt { without, with };
  [[nodiscard]] const std::vector<std::uint16_t>& triangles_of(const DrawnNode& drawn, Skirt skirt,
                                                               NodeLayer layer = NodeLayer::ground) const;

  [[nodiscard]] int made() const { return made_; }               // nodes, also those that are not drawn
  [[nodiscard]] double making_ms() const { return making_ms_; }  // of all of them, from nothing
  // Of nodes that found no room.
  [[nodiscard]] std::size_t missing() const { return choice_.lacks ? choice_.missing.size() : 0; }

 private:
  // Returns whether there was room.
  bool make(const GridNode& node);
  bool make_missing();

  Scene scene_;
  View view_;
  Pose pose_;
  Needs needs_;
  f64::Terrain terrain_;
  std::shared_ptr<const NodeGrid> grid_;
  NodePatch patch_;
  NodeRanges ranges_;
  NodeSight sight_;
  NodeDetails details_;
  NodeEye eye_;
  NodeCache cache_;
  NodeChoice choice_;
  NodeVertices scratch_;
  std::vector<NodeVertices> vertices_;  // by slot
  std::array<std::array<std::vector<std::uint16_t>, most_node_lists>, 2>
      triangles_;  // by skirt, as node_triangles has lists
  int made_ = 0;
  double making_ms_ = 0.0;
};

}  // namespace terrella
