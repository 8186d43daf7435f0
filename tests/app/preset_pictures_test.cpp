#include "app/preset_pictures.hpp"

#include <gtest/gtest.h>

#include "app/still.hpp"
#include "effort.hpp"
#include "measure/image_error.hpp"
#include "native/egl_context.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

constexpr int width = 128, height = 72;

// Top row first, 0..1.
Image texture_as_image(GLuint texture) {
  std::vector<unsigned char> bytes(std::size_t{4} * width * height);
  glBindTexture(GL_TEXTURE_2D, texture);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t from = 4 * static_cast<std::size_t>((height - 1 - y) * width + x);
      EXPECT_EQ(bytes[from + 3], 255);
      for (std::size_t c = 0; c < 3; ++c) image.at(x, y)[c] = static_cast<float>(bytes[from + c]) / 255.0F;
    }
  }
  return image;
}

// Of half the width and height.
Image halved(const Image& large) {
  Image small(width, height, 3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const auto at = [&](int dx, int dy) { return large.at(2 * x + dx, 2 * y + dy)[c]; };
        small.at(x, y)[c] = 0.25F * (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1));
      }
    }
  }
  return small;
}

TEST(PresetPictures, AreWhatThePresetsShow) {
  if (test::sanitized) GTEST_SKIP() << test::too_long_sanitized;
  const std::unique_ptr<EglContext> context = std::move(*EglContext::make(Api::core));
  PresetPictures pictures;
  for (int i = 0; i < 5000 && !pictures.complete(); ++i) pictures.advance();
  ASSERT_TRUE(pictures.complete());
  ASSERT_EQ(pictures.textures().size(), presets().size());
  Renderer renderer;
  StillOptions options;
  options.width = 2 * width;
  options.height = 2 * height;
  const auto step = static_cast<std::size_t>(test::by_effort(1, 3));
  for (std::size_t i = 0; i < presets().size(); i += step) {
    Scene scene = presets()[i].scene;
    scene.quality.antialias = false;
    const Image whole = halved(take_picture(renderer, scene, options));
    const double likeness = psnr(texture_as_image(pictures.textures()[i]), whole);
    // Measured 18.9 and 21.6 (atolls and isles, whose near clouds are finer than the small maps) to 40.9 dB.
    EXPECT_GT(likeness, 18.5) << presets()[i].name;
    const GLuint next = pictures.textures()[(i + 1) % presets().size()];
    EXPECT_LT(psnr(texture_as_image(next), whole), likeness - 3.0) << presets()[i].name;
  }
}

}  // namespace
}  // namespace terrella
