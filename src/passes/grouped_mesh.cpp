#include "passes/grouped_mesh.hpp"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

namespace terrella {

GroupedMesh::GroupedMesh(std::span<const glm::vec3> vertices, GroupedTriangles triangles)
    : mesh_(vertices), triangles_(std::move(triangles)) {
  radii_.reserve(vertices.size());
  for (const glm::vec3& vertex : vertices) radii_.push_back(glm::length(vertex));
}

void GroupedMesh::set(GroupedTriangles triangles) {
  triangles_ = std::move(triangles);
  parts_.forget();
}

void GroupedMesh::draw(const Frame& frame, Chosen groups, double lowest) {
  if (lowest != lowest_) parts_.forget();
  lowest_ = lowest;
  const auto append = [&](const Chosen& drawn, std::vector<std::uint32_t>& chosen) {
    const auto radius = static_cast<float>(lowest);
    const std::vector<std::uint32_t>& all = triangles_.indices;
    for (const std::uint32_t g : drawn) {
      for (std::size_t i = 3 * std::size_t{triangles_.starts[g]}; i < 3 * std::size_t{triangles_.starts[g + 1]};
           i += 3) {
        if (std::max({radii_[all[i]], radii_[all[i + 1]], radii_[all[i + 2]]}) >= radius) {
          chosen.insert(chosen.end(), {all[i], all[i + 1], all[i + 2]});
        }
      }
    }
  };
  const auto send = [&](const std::vector<std::uint32_t>& indices) { mesh_.set_indices(indices); };
  // Beside that in the mirror, it is not for all that is drawn.
  const bool whole = draws_all(frame) && !frame.is_mirror;
  const auto [first, count] = parts_.range_of(std::move(groups), whole, append, send);
  mesh_.draw(first, count);
}

}  // namespace terrella
