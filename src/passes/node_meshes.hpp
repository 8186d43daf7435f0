// The nodes of a grid on the GPU: made as they are needed, kept within a fixed budget of memory, and drawn as
// ground or as sea.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "gl/height_texture.hpp"
#include "gl/mesh.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "passes/frame.hpp"
#include "planet/node_layers.hpp"

namespace terrella {

// Of the textures that hold what NodeVertices has, in its order: a texel a vertex. Rows hold nodes one after another,
// no more of them than OpenGL ES 3.0 lets a texture have, and then on beside the first.
inline constexpr int most_node_rows = 2048;
inline constexpr std::array node_formats = {gl::Format::rgba32f, gl::Format::rgba32f, gl::Format::rgba16f,
                                            gl::Format::rgba16f, gl::Format::rgba16f, gl::Format::rgba16f,
                                            gl::Format::rgba32f};

// A node's instance, in vec4s.
inline constexpr int vec4s_a_node = 5;

class NodeMeshes {
 public:
  // Takes memory for nodes of so many cells, which update would take else. grid: any of those that it will be asked
  // for.
  void make_room(const NodeGrid& grid, int cells);

  enum class Making { in_time, none };

  // Chooses what is drawn, and makes what is missing: all of it where the frame is to be complete, else as much as a
  // frame has time for, or no more than the undivided nodes. grid: another one than before starts anew; its patches are
  // the same.
  void update(const Frame& frame, std::shared_ptr<const NodeGrid> grid, Making making = Making::in_time);

  // program: in use, its vertices by shaders/node_vertex.glsl. of_level: tells it how far apart (rad) vertices are of
  // the coarsest of the nodes that are drawn next.
  using OfLevel = std::function<void(double spacing)>;
  void draw(const Frame& frame, const gl::Program& program, NodeLayer layer, const OfLevel& of_level = {}) const;

  // As of GroundPass.
  [[nodiscard]] double mirrored_climb() const { return mirrored_climb_; }

  // Whether nothing is missing that there is room for.
  [[nodiscard]] bool settled() const { return !choice_.lacks || is_full_; }
  [[nodiscard]] std::int64_t noise_evaluations() const { return noise_evaluations_; }

 private:
  [[nodiscard]] bool sea_is_coarser() const { return sight_.sea > 0.0 && sea_ranges_.split < ranges_.split; }
  [[nodiscard]] const std::vector<DrawnNode>& drawn_as(NodeLayer layer) const {
    return is_sea(layer) && sea_is_coarser() ? sea_choice_.drawn : choice_.drawn;
  }
  // Forgets what was made for another grid or another relief.
  void start_anew(const Frame& frame);
  void choose();
  // Makes those that are missing until they or the time (ms) come to an end.
  void make_missing(const Frame& frame, double time);
  // Returns whether there was room.
  bool make(const Scene& scene, const GridNode& node);
  void pack(const Frame& frame);

  // A list of triangles among all.
  struct List {
    std::size_t first = 0, count = 0;  // indices
  };
  // Nodes of one list of triangles among the instances; of deep sea with waves of one level, too.
  struct Run {
    std::size_t list = 0, first = 0, count = 0;
    int coarsest = 0;  // level
  };

  NodeCache cache_{1};  // until there is room for more
  NodeChoice choice_, sea_choice_;
  NodeEye eye_;
  NodeSight sight_;
  NodeVertices vertices_;
  std::shared_ptr<const NodeGrid> grid_;
  NodePatch patch_;
  int rows_ = 0;  // of the textures
  NodeRanges ranges_, sea_ranges_;
  std::optional<NodeDetails> details_;  // of the relief and the patch
  std::optional<f64::Terrain> terrain_;
  std::optional<gl::HeightTexture> heights_;  // of its map
  std::array<std::unique_ptr<gl::Image>, node_formats.size()> textures_;
  std::array<List, most_node_lists> lists_;  // of the triangles (node_triangles)
  std::unique_ptr<gl::Instances> meshes_;
  std::array<std::vector<Run>, node_layers> runs_;  // of the layers
  std::vector<glm::vec4> instances_;
  // Room to sort a layer's nodes.
  struct InOrder {
    unsigned list;
    int level;
    DrawnNode drawn;
  };
  std::vector<InOrder> order_;
  double mirrored_climb_ = 0.0;
  bool is_full_ = false;
  std::int64_t noise_evaluations_ = 0;
};

}  // namespace terrella
