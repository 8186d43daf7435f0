#include "passes/grouped_mesh.hpp"

#include <utility>

namespace terrella {

GroupedMesh::GroupedMesh(std::span<const glm::vec3> vertices, GroupedTriangles triangles)
    : mesh_(vertices), triangles_(std::move(triangles)) {}

void GroupedMesh::set(GroupedTriangles triangles) {
  triangles_ = std::move(triangles);
  groups_.clear();
  mesh_.set_indices({});
}

void GroupedMesh::draw(std::vector<std::uint32_t> groups) {
  if (groups != groups_) {
    std::vector<std::uint32_t> chosen;
    for (const std::uint32_t g : groups) {
      const std::size_t first = triangles_.starts[g], end = triangles_.starts[g + 1];
      const auto group = std::span(triangles_.indices).subspan(3 * first, 3 * (end - first));
      chosen.insert(chosen.end(), group.begin(), group.end());
    }
    mesh_.set_indices(chosen);
    groups_ = std::move(groups);
  }
  mesh_.draw();
}

}  // namespace terrella
