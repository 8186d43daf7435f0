#include "measure/ground_models.hpp"

#include <algorithm>
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

bool is_ground_of_nodes(Ground model) {
  const std::span<const Ground> models_here = ground_models();
  return std::find(models_here.begin(), models_here.end(), model) != models_here.end();
}

Scene with_ground(Scene scene, Ground model) {
  const auto issue = assign_text(scene, "terrain.model", name_of(model));
  CHECK(!issue, name_of(model));
  return scene;
}

}  // namespace terrella
