#include "passes/sphere_meshes.hpp"

#include <utility>
#include <vector>

namespace terrella {

const Icosphere& SphereMeshes::geometry(int level) {
  auto& entry = geometry_.at(static_cast<std::size_t>(level));
  if (!entry) entry = std::make_unique<Icosphere>(make_icosphere(level));
  return *entry;
}

gl::Mesh& SphereMeshes::directions(int level) {
  auto& entry = directions_.at(static_cast<std::size_t>(level));
  if (!entry) {
    const Icosphere& sphere = geometry(level);
    const std::vector<glm::vec3> rounded(sphere.directions.begin(), sphere.directions.end());
    entry = std::make_unique<gl::Mesh>(rounded, sphere.indices);
  }
  return *entry;
}

void SphereMeshes::draw_visible(gl::Mesh& mesh, int level, const glm::dvec3& eye, double occluder,
                                std::span<const float> tops) {
  std::vector<gl::Mesh::Run> runs;
  for (const auto& [first, end] : visible_triangles(level, eye, occluder, tops)) runs.push_back({first, end});
  mesh.draw(std::move(runs));
}

}  // namespace terrella
