#include "scene/description.hpp"

#include <gtest/gtest.h>

#include "scene/presets.hpp"

namespace terrella {
namespace {

TEST(Description, SaysWhichPlanetItIsAndFromWhereItIsSeen) {
  const Preset* storm = find_preset("storm");
  SceneDocument document{storm->scene, "storm"};
  document.scene.camera.latitude = -1.2;
  document.scene.camera.longitude = 20.4;
  EXPECT_EQ(description(document), storm->title + ", a procedural planet. " + storm->about +
                                       ". Seen from above 1 degree south, 20 degrees east.");
  document.scene.camera.latitude = 0.3;
  document.scene.camera.longitude = -179.8;
  EXPECT_TRUE(description(document).ends_with("Seen from above 0 degrees, 180 degrees west."));
}

TEST(Description, CountsWhatMakesItAnotherPlanet) {
  SceneDocument document;
  document.scene.quality.pixel_error = 3.0;
  EXPECT_EQ(description(document), description(SceneDocument{}));
  document.scene.water.level = 0.01;
  EXPECT_TRUE(description(document).ends_with(" 1 setting changed."));
  document.scene.clouds.coverage = 0.9;
  EXPECT_TRUE(description(document).ends_with(" 2 settings changed."));
}

}  // namespace
}  // namespace terrella
