// The icospheres that several passes draw, made once each.
#pragma once

#include <array>
#include <memory>

#include "passes/grouped_mesh.hpp"

namespace terrella {

class SphereMeshes {
 public:
  // The geometry of a level, on the CPU.
  const Icosphere& geometry(int level);

  // A mesh of unit directions of a level, on the GPU. level: group_level or finer.
  GroupedMesh& directions(int level);

 private:
  std::array<std::unique_ptr<Icosphere>, max_icosphere_level + 1> geometry_;
  std::array<std::unique_ptr<GroupedMesh>, max_icosphere_level + 1> directions_;
};

}  // namespace terrella
