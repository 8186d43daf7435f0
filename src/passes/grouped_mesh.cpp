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
  groups_.clear();
  mesh_.set_indices({});
}

void GroupedMesh::draw(std::vector<std::uint32_t> groups, double lowest) {
  if (groups != groups_ || lowest != lowest_) {
    const auto radius = static_cast<float>(lowest);
    const std::vector<std::uint32_t>& all = triangles_.indices;
    std::vector<std::uint32_t> chosen;
    for (const std::uint32_t g : groups) {
      for (std::size_t i = 3 * std::size_t{triangles_.starts[g]}; i < 3 * std::size_t{triangles_.starts[g + 1]};
           i += 3) {
        if (std::max({radii_[all[i]], radii_[all[i + 1]], radii_[all[i + 2]]}) >= radius) {
          chosen.insert(chosen.end(), {all[i], all[i + 1], all[i + 2]});
        }
      }
    }
    mesh_.set_indices(chosen);
    groups_ = std::move(groups);
    lowest_ = lowest;
  }
  mesh_.draw();
}

}  // namespace terrella
