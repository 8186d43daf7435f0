// What decisions leave out, told by the reference: the scene with it beside the scene without it, drawn both in full.
// Bounds stand a little beside what was measured.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "effort.hpp"
#include "measure/image_error.hpp"
#include "planet/needs.hpp"
#include "reference/picture.hpp"
#include "scene/choices.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

constexpr int width = 128, height = 72;

class Decision : public testing::Test {
  void SetUp() override {
    if (test::sanitized) GTEST_SKIP() << test::too_long_sanitized;
  }
};

View picture_view() {
  View view;
  view.width = width;
  view.height = height;
  return view;
}

Needs needs_of(const Scene& scene) { return terrella::needs_of(scene, picture_view(), pose_of(scene, picture_view())); }

// Where a pixel is smallest on the planet, rad.
double pixel_of(const Scene& scene) {
  const Pose pose = pose_of(scene, picture_view());
  return pose.pixel_angle * pose.clearance;
}

Image light(const Scene& scene, const reference::Footprints& left_out = {}) {
  reference::Options options;
  options.width = width;
  options.height = height;
  options.samples = 3;
  options.left_out = left_out;
  Image image = reference::light(scene, options);
  for (float& value : image.pixels) value = std::min(value, 1.0F);
  return image;
}

double likeness(const char* decision, const Image& with, const Image& without) {
  const double found = psnr(with, without);
  if (std::getenv("TERRELLA_PRINT") != nullptr) std::printf("%-32s %.1f dB\n", decision, found);
  return found;
}

Scene bare() {
  Scene scene;
  scene.clouds.model = scene.air.model = scene.stars.model = 0;
  scene.sun.size = scene.sun.glare = 0.0;
  return scene;
}

TEST_F(Decision, ToLeaveOutWavesOfUnderHalfAPixel) {
  Scene scene = find_preset("storm")->scene;
  scene.clouds.model = scene.stars.model = 0;
  scene.camera.altitude = 6.0;
  scene.camera.pitch = -90.0;
  ASSERT_EQ(needs_of(scene).water, Water::calm);
  const Image with = light(scene);
  scene.waves.count = 0;
  EXPECT_GT(likeness("waves", with, light(scene)), 35.5);  // measured: 35.9, for the sake of glitter
}

TEST_F(Decision, ToLeaveOutRipplesOfUnderTwoPixels) {
  Scene scene = bare();
  scene.camera.altitude = 6.0;
  scene.water.ripple_frequency = 60.0;
  ASSERT_EQ(needs_of(scene).ripple_layers, 0);
  EXPECT_GT(likeness("ripples", light(scene), light(scene, {0.0, 0.0, 1.0})), 51.5);  // 52.0
}

TEST_F(Decision, ToLeaveOutFineLayersOfTheGround) {
  Scene scene = bare();
  scene.water.model = 0;
  const Image with = light(scene);
  EXPECT_GT(likeness("ground layers", with, light(scene, {pixel_of(scene), 0.0, 0.0})),
            23.2);  // 23.6: every layer is as steep as the one before it, and steep ground is rock
}

TEST_F(Decision, ToLeaveOutFineLayersOfClouds) {
  Scene scene = bare();
  scene.terrain.model = scene.water.model = 0;
  scene.clouds.model = 1;
  const double texel = texel_angle(scene.quality.cloud_texels);
  EXPECT_GT(likeness("cloud layers", light(scene), light(scene, {0.0, std::max(pixel_of(scene), texel), 0.0})),
            30.3);  // 30.7
}

TEST_F(Decision, ToLeaveOutTheSunBesideThePicture) {
  Scene scene;
  scene.sun.longitude = 60.0;
  scene.sun.latitude = 0.0;
  ASSERT_EQ(needs_of(scene).sun, SunImage::none);
  ASSERT_GT(scene.sun.glare, 0.0);
  const Image with = light(scene);
  scene.sun.size = scene.sun.glare = 0.0;
  EXPECT_EQ(with.pixels, light(scene).pixels);
}

// Where a parameter of 0 leaves nothing of it to be seen, the picture is that of a scene that has none.
TEST_F(Decision, ToLeaveOutWhatIsNotThere) {
  const auto expect_same = [](const char* what, Scene nothing, Scene none) {
    SCOPED_TRACE(what);
    EXPECT_EQ(light(nothing).pixels, light(none).pixels);
  };
  const Scene all = find_preset("rings")->scene;
  Scene nothing = all, none = all;
  nothing.clouds.coverage = 0.0;
  none.clouds.model = choice("clouds.model", "none");
  expect_same("clouds", nothing, none);
  nothing = none = all;
  nothing.air.density = 0.0;
  none.air.model = choice("air.model", "none");
  expect_same("air", nothing, none);
  nothing = none = all;
  nothing.stars.density = nothing.stars.brightness = 0.0;
  none.stars.model = choice("stars.model", "none");
  expect_same("stars", nothing, none);
  nothing = none = all;
  nothing.rings.density = 0.0;
  none.rings.outer = none.rings.inner;
  expect_same("rings", nothing, none);
  nothing = none = all;
  nothing.waves.amplitude = 0.0;
  nothing.waves.count = 8;
  none.waves.count = 0;
  expect_same("waves", nothing, none);
}

}  // namespace
}  // namespace terrella
