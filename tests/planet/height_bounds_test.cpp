#include "planet/height_bounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "height_maps.hpp"
#include "laws/random_places.hpp"
#include "planet/cube_grid.hpp"
#include "planet/terrain.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

// On nodes of all sizes: no height of the whole ground lies beyond what is told from 8x8 of them.
void expect_whole_ground_within(const f64::Terrain& terrain, test::Places& places, const std::string& name) {
  constexpr int samples = 8;
  const CubeGrid grid;
  for (const int level : {0, 2, 5, 9, 14}) {
    const GridNode node = grid.node_at(places.on_sphere(), level);
    const double apart = grid.edge(level) / samples;
    HeightRange computed = {1e300, -1e300};
    for (int k = 0; k < (samples + 1) * (samples + 1); ++k) {
      const int i = k % (samples + 1), j = k / (samples + 1);
      const glm::dvec3 d = grid.vertex_direction(node, i, j, samples);
      const double height = f64::terrain_height_at(d, terrain, apart).value;
      computed = {std::min(computed.lowest, height), std::max(computed.highest, height)};
    }
    // The vertices of the node lie unevenly by half a cell.
    const HeightRange range = heights_around(terrain, computed, apart, 0.8 * apart,
                                             may_freeze(terrain.ice, grid.middle_of(node), grid.edge(level)));
    EXPECT_LE(range.highest - range.lowest, 1.3 * terrain.height + 0.1);
    for (int n = 0; n < 400; ++n) {
      const glm::dvec3 place =
          glm::normalize(glm::mix(glm::mix(grid.vertex_direction(node, 0, 0, 2), grid.vertex_direction(node, 2, 0, 2),
                                           places.between(0.0, 1.0)),
                                  glm::mix(grid.vertex_direction(node, 0, 2, 2), grid.vertex_direction(node, 2, 2, 2),
                                           places.between(0.0, 1.0)),
                                  places.between(0.0, 1.0)));
      if (!(grid.node_at(place, level) == node)) continue;
      const double height = f64::terrain_height_at(place, terrain, 0.0).value;
      EXPECT_GE(height, range.lowest) << name << " " << level;
      EXPECT_LE(height, range.highest) << name << " " << level;
    }
  }
}

TEST(HeightBounds, HoldTheWholeGroundOfEveryPreset) {
  test::Places places(5);
  for (const Preset& preset : presets()) {
    if (!has_ground(preset.scene)) continue;
    f64::Terrain terrain = exact_terrain_of(preset.scene);
    if (preset.name.size() % 2 == 0) terrain.ranges = {0.6, 2, 0.1};
    expect_whole_ground_within(terrain, places, std::string(preset.name));
  }
}

TEST(HeightBounds, HoldAMapAndWhatIsFiner) {
  test::Places places(7);
  for (const unsigned seed : {1U, 2U, 3U}) {
    Scene scene = find_preset(seed == 2U ? "alps" : "blue")->scene;
    scene.terrain.map = {"a", seed == 3U ? test::smooth_map(512, 256) : test::rough_map(128, 64, seed)};
    scene.terrain.craters = seed == 1U ? 0.5 : 0.0;
    expect_whole_ground_within(exact_terrain_of(scene), places, "map");
  }
}

// All that rises over the flat ground are ranges.
TEST(HeightBounds, HoldRangesWherePowerIsNone) {
  test::Places places(6);
  f64::Terrain terrain = exact_terrain_of(find_preset("blue")->scene);
  terrain.power = 0.0;
  terrain.ranges = {0.6, 2, 0.1};
  for (int n = 0; n < 20; ++n) expect_whole_ground_within(terrain, places, "flat");
}

}  // namespace
}  // namespace terrella
