#include "planet/needs.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace terrella
