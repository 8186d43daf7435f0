#include "planet/needs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "planet/grids.hpp"
#include "planet/node_layers.hpp"
#include "planet/terrain.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

TEST(MayMove, IsTrueWhereverSomethingMoves) {
  for (const Preset& preset : presets()) {
    const View view;
    const Needs needs = needs_of(preset.scene, view, pose_of(preset.scene, view));
    if (needs.moving) {
      EXPECT_TRUE(may_move(preset.scene)) << preset.name;
    }
  }
}

TEST(MayMove, IsFalseWhereNothingCan) {
  Scene scene;
  scene.clouds.model = 0;
  scene.waves.count = 0;
  EXPECT_TRUE(may_move(scene));  // its ripples
  Scene still = scene;
  still.water.ripples = still.water.crust = 0.0;
  EXPECT_FALSE(may_move(still));
  scene.time.speed = 0.0;
  EXPECT_FALSE(may_move(scene));
}

// Nobody asks for layers that integers of 32 bits do not tell the cells of: not what stands on the ground, and neither
// vertices nor pixels, however near the eye is.
TEST(FinestLayers, HaveCellsThatIntegersTell) {
  constexpr double most_cells_a_radian = 2147483648.0;
  const auto is_told = [](double footprint) { return f64::layer_weight(most_cells_a_radian, footprint) == 0.0; };
  EXPECT_TRUE(is_told(finest_footprint));
  for (const char* preset : {"blue", "giant"}) {
    Scene scene = find_preset(preset)->scene;
    scene.planet.radius = 1e8;
    scene.terrain.octaves = 32;
    scene.terrain.lacunarity = 2.2;
    scene.camera.altitude = 0.0;
    const View view;
    const Needs needs = needs_of(scene, view, pose_of(scene, view));
    for (const test::Grid kind : {test::Grid::cube, test::Grid::icosahedron, test::Grid::persistent}) {
      const auto grid = test::grid_for(kind);
      const NodeRanges ranges = ranges_of(*grid, needs);
      EXPECT_TRUE(is_told(grid->spacing(ranges.deepest, needs.ground_cells))) << preset << " " << kind;
    }
    const double finest = scene.terrain.frequency * std::pow(scene.terrain.lacunarity, needs.pixel_octaves_end - 1);
    EXPECT_LT(finest, most_cells_a_radian) << preset;
    const glm::dvec3 below = direction_of(scene.camera.latitude, scene.camera.longitude);
    Scene dry = scene;
    dry.water.model = 0;
    EXPECT_EQ(surface_radius(dry, below), exact_ground_radius(exact_terrain_of(dry), below, finest_footprint));
  }
}

// Other cells would mean to make all nodes anew, while a window is dragged larger or a view narrowed.
TEST(CellsOfNodes, AreTheSameForPicturesOfAnySize) {
  for (const char* preset : {"blue", "highlands", "isles", "dunes", "craters", "atolls", "frozen", "giant"}) {
    Scene scene = find_preset(preset)->scene;
    const auto needs_for = [&](int rows, double fov) {
      View view;
      view.width = 2 * rows;
      view.height = rows;
      scene.camera.fov = fov;
      return needs_of(scene, view, pose_of(scene, view));
    };
    const int usual = needs_for(720, 45.0).ground_cells;
    double least = most_cells, most = 0.0;
    for (const int rows : {90, 360, 720, 1440, 4320}) {
      for (const double fov : {2.0, 45.0, 120.0}) {
        const Needs needs = needs_for(rows, fov);
        EXPECT_EQ(needs.ground_cells, usual) << preset << " " << rows << " " << fov;
        least = std::min(least, needs.ground_split);
        most = std::max(most, needs.ground_split);
      }
    }
    // Finer pictures are still drawn more finely.
    EXPECT_LT(least, most) << preset;
  }
}

// Where its land can be seen in it: from near, from over the water, and with a law of reflection.
TEST(Water, MirrorsLandWhereThatIsSeen) {
  const auto mirrors = [](const Scene& scene) {
    const View view;
    return needs_of(scene, view, pose_of(scene, view)).mirrored_land > 0.0;
  };
  Scene scene = find_preset("fjords")->scene;
  EXPECT_TRUE(mirrors(scene));
  scene.water.shading = 1;
  EXPECT_FALSE(mirrors(scene));
  scene.water.shading = 0;
  scene.camera.altitude = 2e6;
  EXPECT_FALSE(mirrors(scene));
  scene.camera.altitude = scene.water.level - 5.0;
  EXPECT_TRUE(mirrors(scene));
  scene.water.dive = true;
  EXPECT_FALSE(mirrors(scene));
  EXPECT_FALSE(mirrors(find_preset("temperate")->scene));  // a miniature from afar
}

}  // namespace
}  // namespace terrella
