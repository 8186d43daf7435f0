#include "planet/node_grids.hpp"

#include "base/check.hpp"
#include "planet/cube_grid.hpp"
#include "planet/icosahedron_grid.hpp"
#include "planet/persistent_grid.hpp"

namespace terrella {

std::shared_ptr<const NodeGrid> grid_of(Ground technique, const Scene& scene, const Pose& pose) {
  CHECK(has_nodes(technique), name_of(technique));
  if (technique == Ground::quadtree) return std::make_shared<CubeGrid>();
  if (technique == Ground::triangle_lod) return std::make_shared<IcosahedronGrid>();
  return std::make_shared<PersistentGrid>(pose.eye, relief_top(scene) - 1.0);
}

NodePatch patch_of(Ground technique, int cells) {
  CHECK(has_nodes(technique), name_of(technique));
  return technique == Ground::triangle_lod ? triangle_patch(cells) : square_patch(cells);
}

}  // namespace terrella
