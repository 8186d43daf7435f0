// Planted pictures must be told from that of the scene.
#include "measure/beside_reference.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "measure/cases.hpp"
#include "measure/studio.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

struct Drawn {
  std::vector<float> light, distance;
};

class BesideTheReference : public testing::TestWithParam<const char*> {
 protected:
  BesideTheReference() : scene_(find_preset(GetParam())->scene) {
    make_cheap(scene_);
    make_comparable(scene_);
    view_.width = 64;
    view_.height = 36;
  }
  Drawn drawn(const Scene& scene) {
    const auto of = [&](Channel channel) {
      studio_.renderer.draw(scene, view_, {channel, Effort::complete, true});
      return studio_.renderer.read_light();
    };
    return {of(Channel::color), of(Channel::distance)};
  }
  [[nodiscard]] std::vector<float> mirrored(const std::vector<float>& pixels) const {
    std::vector<float> mirror = pixels;
    const auto width = static_cast<std::size_t>(view_.width);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const std::size_t pixel = i / 4, x = pixel % width;
      mirror[4 * (pixel - x + width - 1 - x) + i % 4] = pixels[i];
    }
    return mirror;
  }
  [[nodiscard]] BesideReference beside(const Drawn& drawn) const {
    return beside_reference(scene_, view_, drawn.light, drawn.distance);
  }

  test::Studio studio_;
  Scene scene_;
  View view_;
};

TEST_P(BesideTheReference, OnlyThePictureOfTheSceneHolds) {
  const Drawn is = drawn(scene_);
  EXPECT_TRUE(beside(is).same_light()) << beside(is).light;
  EXPECT_TRUE(beside(is).same_silhouette()) << beside(is).silhouette;

  EXPECT_FALSE(beside({std::vector<float>(is.light.size(), 0.0F), is.distance}).same_light());

  const Drawn mirror = {mirrored(is.light), mirrored(is.distance)};
  EXPECT_FALSE(beside(mirror).same_light()) << beside(mirror).light;

  Scene another = scene_;
  another.planet.seed += 1;
  const Drawn other = drawn(another);
  EXPECT_FALSE(beside(other).same_light()) << beside(other).light;
}

TEST_P(BesideTheReference, APlanetOfAnotherSizeHasAnotherSilhouette) {
  Scene farther = scene_;
  farther.camera.altitude *= 1.3;
  const Drawn other = drawn(farther);
  EXPECT_FALSE(beside(other).same_silhouette()) << beside(other).silhouette;
}

INSTANTIATE_TEST_SUITE_P(Presets, BesideTheReference, testing::Values("temperate", "storm", "alps"),
                         [](const auto& name) { return std::string(name.param); });

}  // namespace
}  // namespace terrella
