// What tells and shows how far pictures are off.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "measure/base64.hpp"
#include "measure/image_error.hpp"
#include "measure/thumbnail.hpp"

namespace terrella {
namespace {

Image grey(int width, int height, float value) {
  Image image(width, height, 3);
  for (float& channel : image.pixels) channel = value;
  return image;
}

TEST(VisibleShare, CountsPixelsThatOneCanTellApart) {
  const Image a = grey(4, 4, 0.5F);
  EXPECT_EQ(visible_share(a, a), 0.0);
  // Two steps of 8 bits are 0.8 apart in lightness, ten steps 4.
  EXPECT_EQ(visible_share(a, grey(4, 4, 0.5F + 2.0F / 255.0F)), 0.0);
  EXPECT_EQ(visible_share(a, grey(4, 4, 0.5F + 10.0F / 255.0F)), 1.0);
  Image b = a;
  for (int c = 0; c < 3; ++c) b.at(1, 2)[c] = 0.9F;
  EXPECT_EQ(visible_share(a, b), 1.0 / 16.0);
}

TEST(OutlineLength, IsNearlyThatOfCirclesAndLines) {
  constexpr float sky = std::numeric_limits<float>::infinity();
  Image circle(200, 200, 1), line(200, 200, 1);
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) {
      if (std::hypot(x - 100.0, y - 100.0) > 70.0) *circle.at(x, y) = sky;
      if (2 * y > x) *line.at(x, y) = sky;
    }
  }
  EXPECT_NEAR(outline_length(circle), 2.0 * std::numbers::pi * 70.0, 0.05 * 2.0 * std::numbers::pi * 70.0);
  EXPECT_NEAR(outline_length(line), std::hypot(200.0, 100.0), 0.1 * std::hypot(200.0, 100.0));
  EXPECT_EQ(outline_length(Image(9, 9, 1)), 0.0);
}

TEST(Thumbnail, IsTheMeanOfWhatItStandsFor) {
  Image image(500, 300, 1);
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 500; ++x) *image.at(x, y) = static_cast<float>(x);
  }
  const Image small = thumbnail(image, 100);
  EXPECT_EQ(small.width, 100);
  EXPECT_EQ(small.height, 60);
  EXPECT_NEAR(*small.at(0, 0), 2.0F, 1e-4F);
  EXPECT_NEAR(*small.at(99, 59), 497.0F, 1e-3F);
  EXPECT_NEAR(mean_of(small), mean_of(image), 1e-3);
  EXPECT_EQ(thumbnail(image, 500).pixels, image.pixels);
  EXPECT_EQ(thumbnail(Image(1000, 1, 3), 10).height, 1);
}

TEST(Heat, GrowsLighterFromNothingToMost) {
  Image values(9, 1, 1);
  for (int x = 0; x < 9; ++x) *values.at(x, 0) = 0.125F * static_cast<float>(x);
  const Image colors = heat(values, 0.75);
  double last = -1.0;
  for (int x = 0; x < 9; ++x) {
    const float* c = colors.at(x, 0);
    const double lightness = 0.2126 * double{c[0]} + 0.7152 * double{c[1]} + 0.0722 * double{c[2]};
    EXPECT_TRUE(x > 6 ? lightness == last : lightness > last) << x;
    last = lightness;
  }
}

TEST(Base64, WritesTheExamplesOfItsStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

}  // namespace
}  // namespace terrella
