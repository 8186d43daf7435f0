#include "base/height_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <limits>

#include "base/image.hpp"

namespace terrella {
namespace {

using testing::HasSubstr;

// Of a 16 bit grey PNG.
std::string grey_png(int width, int height, const std::vector<std::uint16_t>& samples) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(width);
  header.height = static_cast<png_uint_32>(height);
  header.format = PNG_FORMAT_LINEAR_Y;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string bytes(size, '\0');
  EXPECT_NE(png_image_write_to_memory(&header, bytes.data(), &size, 0, samples.data(), 0, nullptr), 0);
  bytes.resize(size);
  return bytes;
}

std::string pfm(int width, int height, int channels, float value) {
  Image image(width, height, channels);
  std::fill(image.pixels.begin(), image.pixels.end(), value);
  return encode_pfm(image);
}

std::string sentence_of(std::string_view bytes) { return read_height_map("a.png", bytes).sentence(); }

TEST(ReadHeightMap, KeepsAllBitsOfAGreyPng) {
  std::vector<std::uint16_t> samples;
  for (int i = 0; i < 32 * 16; ++i) samples.push_back(static_cast<std::uint16_t>(12345 + 7 * i));
  const Result<SharedHeightMap> map = read_height_map("a.png", grey_png(32, 16, samples));
  ASSERT_TRUE(map) << map.sentence();
  // On the equator nothing is smoothed.
  EXPECT_FLOAT_EQ((*map)->at(0, 5, 8), static_cast<float>(12345 + 7 * (8 * 32 + 5)) / 65535.0F);
}

TEST(ReadHeightMap, TakesColoursForTheirLuminance) {
  Image image(32, 16, 3);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 32; ++x) image.at(x, y)[1] = 1.0F;
  }
  for (const std::string& bytes : {encode_png(image), encode_pfm(image)}) {
    const Result<SharedHeightMap> map = read_height_map("a", bytes);
    ASSERT_TRUE(map) << map.sentence();
    EXPECT_FLOAT_EQ((*map)->at(0, 3, 8), 0.7152F);
  }
}

TEST(ReadHeightMap, HasTheNorthPoleInItsFirstRow) {
  Image image(32, 16, 1);
  for (int x = 0; x < 32; ++x) image.at(x, 0)[0] = 1.0F;
  const Result<SharedHeightMap> map = read_height_map("a.pfm", encode_pfm(image));
  ASSERT_TRUE(map) << map.sentence();
  EXPECT_EQ((*map)->at(0, 0, 0), 1.0F);
  EXPECT_EQ((*map)->at(0, 0, 15), 0.0F);
}

TEST(ReadHeightMap, SaysWhatIsWrong) {
  EXPECT_EQ(sentence_of("GIF89a"), "a.png: is neither a PNG nor a portable float map (PFM), by its first bytes.");
  EXPECT_EQ(sentence_of(""), "a.png: is neither a PNG nor a portable float map (PFM), by its first bytes.");
  EXPECT_THAT(sentence_of(pfm(16, 32, 1, 0.5F)), HasSubstr("is 16x32 pixels; allowed is"));
  EXPECT_THAT(sentence_of(pfm(80, 16, 1, 0.5F)), HasSubstr("is 80x16 pixels; allowed is"));
  EXPECT_THAT(sentence_of(pfm(8, 4, 1, 0.5F)), HasSubstr("is 8x4 pixels; allowed is"));
  EXPECT_THAT(sentence_of("Pf\n100000 50000\n-1.0\n"), HasSubstr("is 100000x50000 pixels; allowed is"));
  EXPECT_THAT(sentence_of("Pf\nwide 16\n-1.0\n"), HasSubstr("is no portable float map"));
  EXPECT_THAT(sentence_of(pfm(32, 16, 1, 0.5F).substr(0, 500)), HasSubstr("breaks off: 32x16 pixels take 2048 bytes"));
  EXPECT_EQ(sentence_of(pfm(32, 16, 1, 1.5F)),
            "a.png: the height in column 1 of row 1 is 1.5; allowed are 0 to 1, parts of terrain.height.");
  for (const float bad : {-0.1F, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    EXPECT_THAT(sentence_of(pfm(32, 16, 1, bad)), HasSubstr("allowed are 0 to 1"));
  }
}

TEST(ReadHeightMap, SaysWhereAPngIsDamaged) {
  const std::string whole = grey_png(32, 16, std::vector<std::uint16_t>(std::size_t{32 * 16}, 777));
  for (const std::size_t length : {std::size_t{8}, std::size_t{30}, whole.size() / 2, whole.size() - 20}) {
    EXPECT_THAT(sentence_of(whole.substr(0, length)), HasSubstr("a.png: cannot be read as a PNG: ")) << length;
  }
  std::string changed = whole;
  char& inside = changed[changed.size() - 30];  // of the last rows
  inside = static_cast<char>(inside ^ 0x55);
  EXPECT_THAT(sentence_of(changed), HasSubstr("a.png: cannot be read as a PNG: "));
  EXPECT_THAT(sentence_of(grey_png(16, 32, std::vector<std::uint16_t>(std::size_t{512}, 1))), HasSubstr("is 16x32"));
}

TEST(HeightMap, HasCoarserLevelsOfTheSameMean) {
  std::vector<float> heights;
  for (int i = 0; i < 90 * 45; ++i) heights.push_back(static_cast<float>(i % 7) / 6.0F);
  const HeightMap map(90, 45, heights);
  ASSERT_EQ(map.levels().size(), 4U);
  EXPECT_EQ(map.levels()[1].width, 45);
  EXPECT_EQ(map.levels()[1].height, 22);
  EXPECT_EQ(map.levels()[3].height, 5);
  for (const HeightMap::Level& level : map.levels()) {
    double sum = 0.0;
    for (const float height : level.heights) sum += static_cast<double>(height);
    EXPECT_NEAR(sum / static_cast<double>(level.heights.size()), 0.5, 2e-3);
  }
  EXPECT_NE(map.serial(), HeightMap(90, 45, heights).serial());
}

TEST(HeightMap, RowsBesideAPoleAreOfOneHeight) {
  std::vector<float> heights;
  for (int i = 0; i < 64 * 32; ++i) heights.push_back(static_cast<float>((i * 37) % 101) / 100.0F);
  const HeightMap map(64, 32, std::move(heights));
  for (int level = 0; level < static_cast<int>(map.levels().size()); ++level) {
    const int rows = map.levels()[static_cast<std::size_t>(level)].height;
    const int columns = map.levels()[static_cast<std::size_t>(level)].width;
    for (const int row : {0, 1, rows - 2, rows - 1}) {
      for (int x = 0; x < columns; ++x) ASSERT_EQ(map.at(level, x, row), map.at(level, 0, row));
    }
  }
}

}  // namespace
}  // namespace terrella
