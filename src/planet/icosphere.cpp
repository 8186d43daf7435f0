#include "planet/icosphere.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/check.hpp"

namespace terrella {
namespace {

using Corners = std::array<glm::dvec3, 3>;

const std::array<glm::dvec3, 12>& icosahedron_corners() {
  static const auto corners = [] {
    const double t = 0.5 * (1.0 + std::sqrt(5.0));
    std::array<glm::dvec3, 12> c = {{{-1, t, 0},
                                     {1, t, 0},
                                     {-1, -t, 0},
                                     {1, -t, 0},
                                     {0, -1, t},
                                     {0, 1, t},
                                     {0, -1, -t},
                                     {0, 1, -t},
                                     {t, 0, -1},
                                     {t, 0, 1},
                                     {-t, 0, -1},
                                     {-t, 0, 1}}};
    for (glm::dvec3& corner : c) corner = glm::normalize(corner);
    return c;
  }();
  return corners;
}

constexpr std::array<std::array<std::uint32_t, 3>, 20> icosahedron_faces = {
    {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};

// Makes the vertex in the middle of an edge, once for the two triangles that share it.
class Midpoints {
 public:
  Midpoints(std::vector<glm::dvec3>& directions, std::size_t edges)
      : directions_(directions), made_(directions.size()) {
    directions_.reserve(directions_.size() + edges);
  }

  std::uint32_t between(std::uint32_t a, std::uint32_t b) {
    Edges& edges = made_[std::min(a, b)];
    const std::uint32_t end = std::max(a, b);
    const auto edge =
        std::find_if(edges.begin(), edges.end(), [&](const Edge& e) { return e.end == end || e.end == 0; });
    CHECK(edge != edges.end(), a, b);
    if (edge->end == 0) {
      *edge = {end, static_cast<std::uint32_t>(directions_.size())};
      directions_.push_back(glm::normalize(directions_[a] + directions_[b]));
    }
    return edge->middle;
  }

 private:
  struct Edge {
    std::uint32_t end = 0;  // the vertex of the higher number; 0, which is no edge's end, where there is none yet
    std::uint32_t middle = 0;
  };
  using Edges = std::array<Edge, 6>;  // as many meet in a vertex at most

  std::vector<glm::dvec3>& directions_;
  std::vector<Edges> made_;  // for each vertex those of its edges that end in a vertex of a higher number
};

std::vector<std::uint32_t> subdivided(const std::vector<std::uint32_t>& indices, std::vector<glm::dvec3>& directions) {
  Midpoints midpoints(directions, indices.size() / 2);
  std::vector<std::uint32_t> finer;
  finer.reserve(indices.size() * 4);
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const std::uint32_t a = indices[i], b = indices[i + 1], c = indices[i + 2];
    const std::uint32_t ab = midpoints.between(a, b), bc = midpoints.between(b, c), ca = midpoints.between(c, a);
    finer.insert(finer.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
  }
  return finer;
}

// Twice the area of the triangle opposite to each corner, seen from the centre; all positive inside.
glm::dvec3 areas(const Corners& corners, const glm::dvec3& direction) {
  return {glm::dot(direction, glm::cross(corners[1], corners[2])),
          glm::dot(direction, glm::cross(corners[2], corners[0])),
          glm::dot(direction, glm::cross(corners[0], corners[1]))};
}

// How far inside a direction is: the least of the areas. A place on an edge is inside of both its triangles.
double insideness(const Corners& corners, const glm::dvec3& direction) {
  const glm::dvec3 a = areas(corners, direction);
  return std::min(a.x, std::min(a.y, a.z));
}

template <class Candidates>
Corners best_of(const Candidates& candidates, const glm::dvec3& direction) {
  const Corners* best = &candidates[0];
  for (const Corners& candidate : candidates) {
    if (insideness(candidate, direction) > insideness(*best, direction)) best = &candidate;
  }
  return *best;
}

}  // namespace

Icosphere make_icosphere(int level) {
  CHECK(level >= 0 && level <= max_icosphere_level, level);
  Icosphere sphere;
  sphere.directions.assign(icosahedron_corners().begin(), icosahedron_corners().end());
  for (const auto& face : icosahedron_faces) sphere.indices.insert(sphere.indices.end(), face.begin(), face.end());
  for (int i = 0; i < level; ++i) sphere.indices = subdivided(sphere.indices, sphere.directions);
  return sphere;
}

double icosphere_edge(int level) {
  CHECK(level >= 0 && level <= max_icosphere_level, level);
  // Longest edges, computed from the geometry; each level is a little more than half of the one before.
  constexpr std::array<double, max_icosphere_level + 1> edges = {1.107149, 0.628319, 0.326366, 0.164834, 0.082627,
                                                                 0.041340, 0.020673, 0.010337, 0.005169};
  return edges[static_cast<std::size_t>(level)];
}

IcospherePlace locate_on_icosphere(const glm::dvec3& direction, int level) {
  CHECK(level >= 0 && level <= max_icosphere_level, level);
  const auto& corner = icosahedron_corners();
  std::array<Corners, 20> faces;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto& [a, b, c] = icosahedron_faces[i];
    faces[i] = {corner[a], corner[b], corner[c]};
  }
  Corners t = best_of(faces, direction);
  for (int i = 0; i < level; ++i) {
    const auto& [a, b, c] = t;
    const glm::dvec3 ab = glm::normalize(a + b), bc = glm::normalize(b + c), ca = glm::normalize(c + a);
    t = best_of(std::array<Corners, 4>{{{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}}, direction);
  }
  const glm::dvec3 a = areas(t, direction);
  return {t, a / (a.x + a.y + a.z)};
}

}  // namespace terrella
