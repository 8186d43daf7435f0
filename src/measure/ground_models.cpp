#include "measure/ground_models.hpp"

#include <array>

#include "base/check.hpp"
#include "planet/real_size.hpp"
#include "scene/parameters.hpp"

namespace terrella {
namespace {

constexpr std::array models = {
    Ground::quadtree,
    Ground::triangle_lod,
    Ground::persistent_grid,
};

}  // namespace

std::span<const Ground> ground_models() {
  if (!has_real_size) return {};
  return models;
}

Scene with_ground(Scene scene, Ground model) {
  const auto issue = assign_text(scene, "terrain.model", name_of(model));
  CHECK(!issue, name_of(model));
  return scene;
}

}  // namespace terrella
