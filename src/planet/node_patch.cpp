#include "planet/node_patch.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace terrella {
namespace {

unsigned side(unsigned number) { return first_side << number; }
unsigned corner(unsigned number) { return first_corner << number; }

std::uint16_t square_number(int i, int j, int cells) { return static_cast<std::uint16_t>(j * (cells + 1) + i); }

// Rows of j, each by one shorter than that before.
std::uint16_t triangle_number(int i, int j, int cells) {
  return static_cast<std::uint16_t>(j * (cells + 1) - j * (j - 1) / 2 + i);
}

unsigned touches_of_square(int i, int j, int cells) {
  const bool left = i == 0, right = i == cells, bottom = j == 0, top = j == cells;
  return (left ? side(0) : 0) | (right ? side(1) : 0) | (bottom ? side(2) : 0) | (top ? side(3) : 0) |
         (left && bottom ? corner(0) : 0) | (right && bottom ? corner(1) : 0) | (left && top ? corner(2) : 0) |
         (right && top ? corner(3) : 0);
}

unsigned touches_of_triangle(int i, int j, int cells) {
  const bool on_0 = i + j == cells, on_1 = i == 0, on_2 = j == 0;
  return (on_0 ? side(0) : 0) | (on_1 ? side(1) : 0) | (on_2 ? side(2) : 0) | (on_1 && on_2 ? corner(0) : 0) |
         (on_2 && on_0 ? corner(1) : 0) | (on_0 && on_1 ? corner(2) : 0);
}

void add_triangle(NodePatch& patch, std::uint16_t a, std::uint16_t b, std::uint16_t c) {
  patch.triangles.insert(patch.triangles.end(), {a, b, c});
}

// left_out: the sides along which every second vertex is left out.
void add_skirt(const NodePatch& patch, unsigned left_out, std::vector<std::uint16_t>& indices) {
  const auto count = patch.rim.size();
  for (std::size_t place = 0; place < count;) {
    // What both ends of an edge lie on is its side.
    const unsigned on =
        patch.vertices[patch.rim[place]].touches & patch.vertices[patch.rim[(place + 1) % count]].touches;
    const std::size_t next = place + ((on & left_out & all_sides) != 0 ? 2 : 1);
    const auto below = [&](std::size_t k) { return static_cast<std::uint16_t>(patch.vertices.size() + k % count); };
    const std::uint16_t a = patch.rim[place], b = patch.rim[next % count];
    indices.insert(indices.end(), {a, b, below(next), a, below(next), below(place)});
    place = next;
  }
}

}  // namespace

int node_room(int vertices) {
  constexpr int least = 2048, most = 4096, of_largest = vertices_of_patch(4, 28);
  return std::clamp(least * of_largest / vertices, least, most);
}

NodePatch square_patch(int cells) {
  CHECK(cells > 0 && cells % 2 == 0, cells);
  NodePatch patch;
  patch.cells = cells;
  patch.sides = 4;
  const auto number = [&](int i, int j) { return square_number(i, j, cells); };
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      // In the middle of a cell of the level above lies the diagonal from its lower left corner.
      const int odd_i = i % 2, odd_j = j % 2;
      patch.vertices.push_back(
          {i, j, number(i - odd_i, j - odd_j), number(i + odd_i, j + odd_j), touches_of_square(i, j, cells)});
    }
  }
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const auto a = number(i, j), b = number(i + 1, j), c = number(i + 1, j + 1), d = number(i, j + 1);
      add_triangle(patch, a, c, b);
      add_triangle(patch, a, d, c);
    }
  }
  for (int k = 0; k < cells; ++k) patch.rim.push_back(number(k, 0));
  for (int k = 0; k < cells; ++k) patch.rim.push_back(number(cells, k));
  for (int k = 0; k < cells; ++k) patch.rim.push_back(number(cells - k, cells));
  for (int k = 0; k < cells; ++k) patch.rim.push_back(number(0, cells - k));
  return patch;
}

NodePatch triangle_patch(int cells) {
  CHECK(cells > 0 && cells % 2 == 0, cells);
  NodePatch patch;
  patch.cells = cells;
  patch.sides = 3;
  const auto number = [&](int i, int j) { return triangle_number(i, j, cells); };
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i + j <= cells; ++i) {
      // Where both are odd it lies on the side of a triangle of the level above along which their sum is the same.
      const int odd_i = i % 2, odd_j = j % 2, falls = odd_i * odd_j;
      patch.vertices.push_back({i, j, number(i - odd_i, j - odd_j + 2 * falls),
                                number(i + odd_i, j + odd_j - 2 * falls), touches_of_triangle(i, j, cells)});
    }
  }
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i + j < cells; ++i) {
      add_triangle(patch, number(i, j), number(i + 1, j), number(i, j + 1));
      if (i + j < cells - 1) add_triangle(patch, number(i + 1, j + 1), number(i, j + 1), number(i + 1, j));
    }
  }
  for (int k = 0; k < cells; ++k) patch.rim.push_back(number(0, k));
  for (int k = 0; k < cells; ++k) patch.rim.push_back(number(k, cells - k));
  for (int k = 0; k < cells; ++k) patch.rim.push_back(number(cells - k, 0));
  return patch;
}

std::vector<std::uint16_t> node_triangles(const NodePatch& patch, unsigned list, bool skirt) {
  const bool every_second = list == patch.list_of_every_second();
  const unsigned left_out = every_second ? all_sides : list;
  // A vertex that is left out falls onto the one before it on its side, and so do the triangles that it is a corner of.
  const auto kept = [&](std::uint16_t n) {
    const NodePatch::Vertex& vertex = patch.vertices[n];
    return every_second || (vertex.touches & left_out & all_sides) != 0 ? vertex.from : n;
  };
  std::vector<std::uint16_t> indices;
  for (std::size_t n = 0; n < patch.triangles.size(); n += 3) {
    const auto a = kept(patch.triangles[n]), b = kept(patch.triangles[n + 1]), c = kept(patch.triangles[n + 2]);
    if (a != b && b != c && c != a) indices.insert(indices.end(), {a, b, c});
  }
  if (skirt) add_skirt(patch, left_out, indices);
  return indices;
}

}  // namespace terrella
