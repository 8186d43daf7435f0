#include "passes/sphere_meshes.hpp"

#include <vector>

namespace terrella {

const Icosphere& SphereMeshes::geometry(int level) {
  auto& entry = geometry_.at(static_cast<std::size_t>(level));
  if (!entry) entry = std::make_unique<Icosphere>(make_icosphere(level));
  return *entry;
}

GroupedMesh& SphereMeshes::directions(int level) {
  auto& entry = directions_.at(static_cast<std::size_t>(level));
  if (!entry) {
    const Icosphere& sphere = geometry(level);
    const std::vector<glm::vec3> rounded(sphere.directions.begin(), sphere.directions.end());
    entry = std::make_unique<GroupedMesh>(rounded, all_triangles(sphere));
  }
  return *entry;
}

}  // namespace terrella
