#include "passes/ground.hpp"

#include "passes/ground_icosphere.hpp"
#include "passes/ground_quadtree.hpp"
#include "planet/real_size.hpp"

namespace terrella {

std::unique_ptr<GroundPass> make_ground(Ground technique, SphereMeshes& spheres) {
  if constexpr (has_real_size) {
    if (technique == Ground::quadtree) return std::make_unique<GroundQuadtree>();
  }
  return std::make_unique<GroundIcosphere>(spheres);
}

}  // namespace terrella
