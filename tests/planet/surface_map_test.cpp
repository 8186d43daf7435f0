#include "planet/surface_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "planet/pose.hpp"
#include "planet/terrain.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

constexpr int width = 64, height = 32;

std::vector<glm::vec4> map_of(const Scene& scene) {
  const SurfaceMap map(scene, height);
  std::vector<glm::vec4> colors(std::size_t{width} * height);
  for (int row = 0; row < height; ++row) {
    map.make_row(row, std::span(colors).subspan(static_cast<std::size_t>(row) * width, width));
  }
  return colors;
}

glm::vec4 color_at(const std::vector<glm::vec4>& map, double latitude, double longitude) {
  const auto row = static_cast<std::size_t>((0.5 - latitude / 180.0) * height);
  const auto column = static_cast<std::size_t>((longitude / 360.0 + 0.5) * width);
  return map.at(row * width + column);
}

TEST(SurfaceMap, HasAColourForEveryPlaceOfEveryPreset) {
  for (const Preset& preset : presets()) {
    for (const glm::vec4& color : map_of(preset.scene)) {
      for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(color[i] >= 0.0F && color[i] <= 1.0F) << preset.name;
      }
      ASSERT_EQ(color.a, 1.0F);
    }
  }
}

TEST(SurfaceMap, ShowsLandWhereLandIsAndTheSeaWhereItIsDeep) {
  Scene scene = presets().front().scene;
  scene.terrain.land_color = scene.terrain.sand_color = scene.terrain.mountain_color = {255, 0, 0};
  scene.terrain.snow_color = scene.terrain.seabed_color = {255, 0, 0};
  scene.terrain.snow_latitude = scene.water.ice_latitude = 90.0;
  scene.water.color = {0, 0, 255};
  const std::vector<glm::vec4> map = map_of(scene);
  const double sea = water_level(scene) / scene.planet.radius, footprint = 3.14159 / height;
  int land = 0, deep = 0;
  for (int row = 1; row < height - 1; ++row) {
    for (int column = 0; column < width; ++column) {
      const double latitude = 90.0 - 180.0 * (row + 0.5) / height, longitude = 360.0 * (column + 0.5) / width - 180.0;
      const glm::vec4 color = color_at(map, latitude, longitude);
      const double ground = exact_ground_radius(exact_terrain_of(scene), direction_of(latitude, longitude), footprint);
      if (ground - 1.0 > sea) {
        ++land;
        ASSERT_GT(color.r, color.b) << latitude << ' ' << longitude;
      } else if (sea - ground + 1.0 > 2.0 * scene.water.clarity / scene.planet.radius) {
        ++deep;
        ASSERT_GT(color.b, color.r) << latitude << ' ' << longitude;
      }
    }
  }
  EXPECT_GT(land, 100);
  EXPECT_GT(deep, 100);
}

TEST(SurfaceMap, IsOfOneColourWithoutGround) {
  Scene scene;
  scene.terrain.model = 0;
  for (const bool sea : {true, false}) {
    if (!sea) scene.water.model = 0;
    const std::vector<glm::vec4> map = map_of(scene);
    for (const glm::vec4& color : map) ASSERT_EQ(color, map.front());
  }
}

}  // namespace
}  // namespace terrella
