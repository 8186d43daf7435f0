#include "measure/node_counts.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "measure/seen_places.hpp"
#include "measure/skyline.hpp"

namespace terrella {
namespace {

struct ListCount {
  std::int64_t vertices, triangles;
};

ListCount count_of(const std::vector<std::uint16_t>& triangles) {
  const std::set<std::uint16_t> vertices(triangles.begin(), triangles.end());
  return {static_cast<std::int64_t>(vertices.size()), static_cast<std::int64_t>(triangles.size() / 3)};
}

}  // namespace

NodeCounts operator+(const NodeCounts& a, const NodeCounts& b) {
  return {a.nodes + b.nodes, a.vertices + b.vertices, a.triangles + b.triangles, a.skirt_vertices + b.skirt_vertices,
          a.skirt_triangles + b.skirt_triangles};
}

NodeCounts node_counts(const NodePicture& picture, NodeLayer layer) {
  NodeCounts counts;
  for (const DrawnNode& drawn : picture.drawn()) {
    if (!picture.shows(layer, drawn)) continue;
    const ListCount bare = count_of(picture.triangles_of(drawn, NodePicture::Skirt::without, layer));
    const ListCount whole = count_of(picture.triangles_of(drawn, NodePicture::Skirt::with, layer));
    ++counts.nodes;
    counts.vertices += bare.vertices;
    counts.triangles += bare.triangles;
    counts.skirt_vertices += whole.vertices - bare.vertices;
    counts.skirt_triangles += whole.triangles - bare.triangles;
  }
  return counts;
}

std::int64_t seen_triangles(const NodePicture& picture) {
  const SeenPlaces seen(picture.scene(), picture.view(), picture.pose(), picture.needs());
  GroundSkyline skyline(picture.pose().eye);
  std::int64_t count = 0;
  for (const DrawnNode& drawn : picture.drawn()) {
    if (!picture.shows(NodeLayer::ground, drawn)) continue;
    const std::vector<glm::dvec3> vertices = picture.vertices_of(drawn);
    const std::vector<std::uint16_t>& list = picture.triangles_of(drawn, NodePicture::Skirt::without);
    for (std::size_t i = 0; i < list.size(); i += 3) {
      const std::array<glm::dvec3, 3> corners = {vertices[list[i]], vertices[list[i + 1]], vertices[list[i + 2]]};
      const bool is_hidden =
          std::all_of(corners.begin(), corners.end(), [&](const glm::dvec3& corner) { return skyline.hides(corner); });
      if (!is_hidden && seen.is_seen(corners[0], corners[1], corners[2])) ++count;
    }
    skyline.add(vertices, list);
  }
  return count;
}

std::int64_t coarse_triangles(const NodePicture& picture) {
  std::int64_t count = 0;
  for (const DrawnNode& drawn : picture.drawn()) {
    if (!picture.shows(NodeLayer::ground, drawn) || drawn.as_above) continue;
    const std::vector<double> parts = picture.coarse_parts_of(drawn);
    const std::vector<std::uint16_t>& list = picture.triangles_of(drawn, NodePicture::Skirt::without);
    for (std::size_t i = 0; i < list.size(); i += 3) {
      if (std::min({parts[list[i]], parts[list[i + 1]], parts[list[i + 2]]}) >= 1.0) ++count;
    }
  }
  return count;
}

}  // namespace terrella
