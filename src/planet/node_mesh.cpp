#include "planet/node_mesh.hpp"

#include <algorithm>
#include <array>
#include <span>

#include <glm/geometric.hpp>

#include "planet/terrain.hpp"

namespace terrella {
namespace {

// In double precision, as long as differences are to be taken.
struct Vertex {
  glm::dvec3 place;  // from the middle of the node on the unit sphere
  double height;
  double over;  // the ground that pixels go on with
  glm::dvec4 slope;
  glm::dvec4 shape_slope;
  glm::dvec2 means;
};

// shown: as vertices can carry it; held: as pixels go on with it.
Vertex vertex_of(const glm::dvec3& direction, const glm::dvec3& middle, const f64::Height& shown,
                 const f64::Height& held) {
  const f64::Height& look = shown.iced ? shown : held;
  const auto along = [&](const glm::dvec3& gradient) { return gradient - glm::dot(gradient, direction) * direction; };
  return {direction - middle + shown.value * direction,
          shown.value,
          shown.iced || held.iced ? 0.0 : shown.value - held.value,
          glm::dvec4(along(look.gradient), look.relief),
          glm::dvec4(along(look.shape_gradient), 0.0),
          {held.mean, held.shape + (shown.iced ? ice_flag : 0.0)}};
}

// On the straight edge between both. Pixels find on it the ground and the sphere that bend above it
// (lib/finer_ground.glsl), and are to find the same on both halves.
Vertex between(const Vertex& a, const Vertex& b) {
  Vertex v = {0.5 * (a.place + b.place), 0.5 * (a.height + b.height),           0.5 * (a.over + b.over),
              0.5 * (a.slope + b.slope), 0.5 * (a.shape_slope + b.shape_slope), 0.5 * (a.means + b.means)};
  const auto twice_over = [](const Vertex& of) {
    return 2.0 * of.over + glm::dot(glm::dvec3(of.slope) - of.place, of.place);
  };
  v.over = 0.5 * (0.5 * (twice_over(a) + twice_over(b)) - glm::dot(glm::dvec3(v.slope) - v.place, v.place));
  return v;
}

// The vertices of a node at its own level and as the level above has them.
struct Levels {
  std::vector<Vertex> own, above;
};

Levels vertices_of(const NodeGrid& grid, const NodePatch& patch, const GridNode& node, const glm::dvec3& middle,
                   const f64::Terrain& terrain) {
  Levels levels;
  levels.own.reserve(patch.vertices.size());
  levels.above.resize(patch.vertices.size());
  const auto is_of_above = [&](std::size_t n) { return patch.vertices[n].from == n; };
  const double spacing = grid.spacing(node.level, patch.cells);
  const std::array<double, 4> footprints = {spacing, f64::held_footprint(spacing), 2.0 * spacing,
                                            f64::held_footprint(2.0 * spacing)};
  std::array<f64::Height, 4> heights;
  for (std::size_t n = 0; n < patch.vertices.size(); ++n) {
    const glm::dvec3 direction = grid.vertex_direction(node, patch.vertices[n].i, patch.vertices[n].j, patch.cells);
    heights_at(direction, terrain, std::span(footprints).first(is_of_above(n) ? 4 : 2), heights);
    const auto& [own, held, above, held_above] = heights;
    levels.own.push_back(vertex_of(direction, middle, own, held));
    // Nothing is above the first level: it keeps its shape.
    if (is_of_above(n)) levels.above[n] = vertex_of(direction, middle, node.level > 0 ? above : own, held_above);
  }
  for (std::size_t n = 0; n < patch.vertices.size(); ++n) {
    if (is_of_above(n)) continue;
    levels.above[n] = between(levels.above[patch.vertices[n].from], levels.above[patch.vertices[n].to]);
  }
  return levels;
}

HeightRange range_of(const std::vector<Vertex>& vertices) {
  const auto [lowest, highest] = std::minmax_element(
      vertices.begin(), vertices.end(), [](const Vertex& a, const Vertex& b) { return a.height < b.height; });
  return {lowest->height, highest->height};
}

}  // namespace

NodeFrame make_node(const NodeGrid& grid, const NodePatch& patch, const GridNode& node, const f64::Terrain& terrain,
                    NodeVertices& vertices) {
  NodeFrame frame;
  frame.outline = outline_of(grid, patch, node);
  frame.around = grid.around(node);
  const glm::dvec3& middle = frame.outline.middle;
  const Levels levels = vertices_of(grid, patch, node, middle, terrain);
  const HeightRange computed = range_of(levels.own), coarser = range_of(levels.above);
  frame.shown = {std::min(computed.lowest, coarser.lowest), std::max(computed.highest, coarser.highest)};
  frame.base = levels.own[levels.own.size() / 2].height;
  // From any place the next vertex is at most half the diagonal of a square away, or of what it is stretched to.
  const double spacing = grid.spacing(node.level, patch.cells);
  frame.may_freeze = may_freeze(terrain.ice, middle, frame.outline.half_width);
  frame.heights =
      heights_around(terrain, computed, spacing, std::max(0.7072, 0.5 * grid.reach()) * spacing, frame.may_freeze);
  const glm::dvec3 lift = frame.base * middle;
  for (auto* list : {&vertices.place, &vertices.coarser, &vertices.slope, &vertices.coarser_slope,
                     &vertices.shape_slope, &vertices.coarser_shape_slope, &vertices.means})
    list->clear();
  for (std::size_t n = 0; n < levels.own.size(); ++n) {
    const Vertex &own = levels.own[n], &above = levels.above[n];
    vertices.place.emplace_back(glm::dvec4(own.place - lift, own.over));
    vertices.coarser.emplace_back(glm::dvec4(above.place - own.place, above.over - own.over));
    vertices.slope.emplace_back(own.slope);
    vertices.coarser_slope.emplace_back(above.slope - own.slope);
    vertices.shape_slope.emplace_back(own.shape_slope);
    vertices.coarser_shape_slope.emplace_back(above.shape_slope - own.shape_slope);
    vertices.means.emplace_back(glm::dvec4(own.means, above.means - own.means));
  }
  return frame;
}

}  // namespace terrella
