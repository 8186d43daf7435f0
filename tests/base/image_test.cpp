#include "base/image.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace terrella {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

Image numbered(int width, int height, int channels) {
  Image image(width, height, channels);
  float next = 0;
  for (float& value : image.pixels) value = next++;
  return image;
}

std::vector<unsigned char> decode_png(const std::string& bytes, png_uint_32 format) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()), 0) << header.message;
  EXPECT_EQ(header.format, format);
  std::vector<unsigned char> samples(PNG_IMAGE_SIZE(header));
  EXPECT_NE(png_image_finish_read(&header, nullptr, samples.data(), 0, nullptr), 0) << header.message;
  return samples;
}

TEST(Image, FindsAPixelByItsColumnAndRow) {
  Image image = numbered(4, 3, 3);
  EXPECT_EQ(image.at(0, 0)[0], 0);
  EXPECT_EQ(image.at(1, 0)[0], 3);
  EXPECT_EQ(image.at(0, 1)[2], 14);
  EXPECT_EQ(image.at(3, 2)[2], 35);
}

TEST(ImageDeathTest, APixelOutsideIsAProgrammersError) {
  const Image image(4, 3, 1);
  EXPECT_DEATH(image.at(4, 0), "pixel 4, 0 of 4x3");
  EXPECT_DEATH(image.at(0, -1), "pixel 0, -1 of 4x3");
  EXPECT_DEATH(Image(0, 3, 1), "an image of 0x3");
}

TEST(Pfm, HasItsHeaderAndTheBottomRowFirst) {
  const std::string bytes = encode_pfm(numbered(2, 2, 3));
  const std::string header = "PF\n2 2\n-1.0\n";
  ASSERT_EQ(bytes.substr(0, header.size()), header);
  ASSERT_EQ(bytes.size(), header.size() + 12 * sizeof(float));
  std::array<float, 12> floats{};
  std::memcpy(floats.data(), bytes.data() + header.size(), sizeof floats);
  EXPECT_EQ(floats, (std::array<float, 12>{6, 7, 8, 9, 10, 11, 0, 1, 2, 3, 4, 5}));
}

TEST(Pfm, KeepsInfinitiesAndIsLittleEndian) {
  Image image(1, 1, 1);
  image.pixels = {kInfinity};
  EXPECT_EQ(encode_pfm(image), std::string("Pf\n1 1\n-1.0\n") + std::string("\0\0\x80\x7f", 4));
}

TEST(Png, IsReadBackWithinHalfAStep) {
  for (const int channels : {3, 4}) {
    Image image(16, 16, channels);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      image.pixels[i] = static_cast<float>(i) / static_cast<float>(image.pixels.size());
    }
    const auto samples = decode_png(encode_png(image), channels == 3 ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA);
    ASSERT_EQ(samples.size(), image.pixels.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
      ASSERT_LE(std::abs(static_cast<float>(samples[i]) / 255 - image.pixels[i]), 0.5001f / 255) << i;
    }
  }
}

TEST(Png, ClampsWhatIsBeyondItsRange) {
  Image image(2, 1, 3);
  image.pixels = {-1, 2, kInfinity, -kInfinity, std::nanf(""), 1};
  EXPECT_EQ(decode_png(encode_png(image), PNG_FORMAT_RGB), (std::vector<unsigned char>{0, 255, 255, 0, 0, 255}));
}

TEST(Png, HoldsNoiseThatDoesNotCompress) {
  Image image(257, 129, 3);
  unsigned state = 1;
  for (float& value : image.pixels) value = static_cast<float>((state = state * 1664525u + 1013904223u) >> 24) / 255;
  EXPECT_EQ(decode_png(encode_png(image), PNG_FORMAT_RGB).size(), image.pixels.size());
}

}  // namespace
}  // namespace terrella
