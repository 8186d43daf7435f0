#include "planet/node_mesh.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

namespace terrella {
namespace {

// In double precision, as long as differences are to be taken.
struct Vertex {
  glm::dvec3 place;  // from the middle of the node on the unit sphere
  double height;
  glm::dvec4 slope;
  glm::dvec2 rise;
};

Vertex vertex_at(const glm::dvec3& direction, const glm::dvec3& middle, const f64::Terrain& terrain, double spacing) {
  const f64::Height ground = f64::terrain_height_at(direction, terrain, spacing);
  const glm::dvec3 along = ground.gradient - glm::dot(ground.gradient, direction) * direction;
  const double of_height = terrain.height > 0.0 ? 1.0 / terrain.height : 0.0;
  return {direction - middle + ground.value * direction,
          ground.value,
          glm::dvec4(along, ground.openness),
          {of_height * ground.rise, of_height * ground.ridges}};
}

Vertex between(const Vertex& a, const Vertex& b) {
  return {0.5 * (a.place + b.place), 0.5 * (a.height + b.height), 0.5 * (a.slope + b.slope), 0.5 * (a.rise + b.rise)};
}

int number_of(int i, int j, int cells) { return j * (cells + 1) + i; }

// The vertices of a node at its own level and as the level above has them.
struct Levels {
  std::vector<Vertex> own, above;
};

Levels vertices_of(const QuadNode& node, int cells, const glm::dvec3& middle, const f64::Terrain& terrain) {
  Levels levels;
  const auto count = static_cast<std::size_t>(vertices_a_node(cells));
  levels.own.reserve(count);
  levels.above.resize(count);
  const double spacing = vertex_spacing(node.level, cells);
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const glm::dvec3 direction = vertex_direction(node, i, j, cells);
      levels.own.push_back(vertex_at(direction, middle, terrain, spacing));
      if (i % 2 != 0 || j % 2 != 0) continue;
      levels.above[static_cast<std::size_t>(number_of(i, j, cells))] =
          node.level > 0 ? vertex_at(direction, middle, terrain, 2.0 * spacing) : levels.own.back();
    }
  }
  // In the middle of a cell of the level above lies the diagonal from its lower left corner.
  const auto above = [&](int i, int j) -> Vertex& {
    return levels.above[static_cast<std::size_t>(number_of(i, j, cells))];
  };
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      if (i % 2 != 0 || j % 2 != 0) above(i, j) = between(above(i - i % 2, j - j % 2), above(i + i % 2, j + j % 2));
    }
  }
  return levels;
}

HeightRange range_of(const std::vector<Vertex>& vertices) {
  const auto [lowest, highest] = std::minmax_element(
      vertices.begin(), vertices.end(), [](const Vertex& a, const Vertex& b) { return a.height < b.height; });
  return {lowest->height, highest->height};
}

// The vertex of a place of the rim, counted around from the corner x = y = 0.
int on_rim(int place, int cells) {
  const int side = place / cells % 4, along = place % cells;
  switch (side) {
    case 0: return number_of(along, 0, cells);
    case 1: return number_of(cells, along, cells);
    case 2: return number_of(cells - along, cells, cells);
    default: return number_of(0, cells - along, cells);
  }
}

constexpr std::array<Side, 4> around = {Side::bottom, Side::right, Side::top, Side::left};

bool leaves_out(unsigned coarser, Side side) { return (coarser >> static_cast<unsigned>(side) & 1U) != 0; }

void add_skirt(int cells, unsigned coarser, std::vector<std::uint16_t>& indices) {
  for (int place = 0; place < vertices_a_rim(cells);) {
    const int step = leaves_out(coarser, around.at(static_cast<std::size_t>(place / cells))) ? 2 : 1;
    const int next = place + step;
    const auto a = static_cast<std::uint16_t>(on_rim(place, cells)),
               b = static_cast<std::uint16_t>(on_rim(next, cells));
    const auto below_a = static_cast<std::uint16_t>(vertices_a_node(cells) + place);
    const auto below_b = static_cast<std::uint16_t>(vertices_a_node(cells) + next % vertices_a_rim(cells));
    // Seen from outside, x and y of a face turn clockwise.
    indices.insert(indices.end(), {a, b, below_b, a, below_b, below_a});
    place = next;
  }
}

}  // namespace

NodeFrame make_node(const QuadNode& node, int cells, const f64::Terrain& terrain, NodeVertices& vertices) {
  NodeFrame frame;
  frame.middle = middle_of(node);
  const Levels levels = vertices_of(node, cells, frame.middle, terrain);
  const HeightRange computed = range_of(levels.own);
  frame.base = levels.own[levels.own.size() / 2].height;
  for (int i = 0; i <= cells; i += cells) {
    for (int j = 0; j <= cells; j += cells) {
      frame.half_width = std::max(frame.half_width, glm::distance(vertex_direction(node, i, j, cells), frame.middle));
    }
  }
  // From any place the next vertex is at most half a cell's diagonal away.
  const double spacing = vertex_spacing(node.level, cells);
  frame.heights = heights_around(terrain, computed, spacing, 0.7072 * spacing,
                                 may_freeze(terrain.ice, frame.middle, frame.half_width));
  const glm::dvec3 lift = frame.base * frame.middle;
  for (auto* list : {&vertices.place, &vertices.coarser, &vertices.slope, &vertices.coarser_slope, &vertices.rise})
    list->clear();
  for (std::size_t n = 0; n < levels.own.size(); ++n) {
    const Vertex &own = levels.own[n], &above = levels.above[n];
    vertices.place.emplace_back(glm::dvec4(own.place - lift, own.height - frame.base));
    vertices.coarser.emplace_back(glm::dvec4(above.place - own.place, above.height - own.height));
    vertices.slope.emplace_back(own.slope);
    vertices.coarser_slope.emplace_back(above.slope - own.slope);
    vertices.rise.emplace_back(glm::dvec4(own.rise, above.rise - own.rise));
  }
  return frame;
}

std::vector<std::uint16_t> node_triangles(int cells, unsigned coarser, bool skirt) {
  // A vertex that is left out falls onto the one before it on its side.
  const auto kept = [&](int i, int j) {
    if ((i == 0 && leaves_out(coarser, Side::left)) || (i == cells && leaves_out(coarser, Side::right))) j -= j % 2;
    if ((j == 0 && leaves_out(coarser, Side::bottom)) || (j == cells && leaves_out(coarser, Side::top))) i -= i % 2;
    return static_cast<std::uint16_t>(number_of(i, j, cells));
  };
  std::vector<std::uint16_t> indices;
  const auto add = [&](std::uint16_t a, std::uint16_t b, std::uint16_t c) {
    if (a != b && b != c && c != a) indices.insert(indices.end(), {a, b, c});
  };
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const auto a = kept(i, j), b = kept(i + 1, j), c = kept(i + 1, j + 1), d = kept(i, j + 1);
      add(a, c, b);
      add(a, d, c);
    }
  }
  if (skirt) add_skirt(cells, coarser, indices);
  return indices;
}

}  // namespace terrella
