#include "passes/ground.hpp"

#include "passes/ground_icosphere.hpp"
#include "passes/ground_nodes.hpp"
#include "passes/ground_persistent_grid.hpp"
#include "planet/real_size.hpp"

namespace terrella {

std::unique_ptr<GroundPass> make_ground(Ground technique, SphereMeshes& spheres) {
  if (has_real_size) {
    if (technique == Ground::persistent_grid) return std::make_unique<GroundPersistentGrid>();
    if (has_nodes(technique)) return std::make_unique<GroundFixedGrid>(technique);
  }
  return std::make_unique<GroundIcosphere>(spheres);
}

}  // namespace terrella
