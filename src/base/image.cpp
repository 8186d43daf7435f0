#include "base/image.hpp"

#include <cstdint>
#include <cstring>

#include "base/check.hpp"

namespace terrella {
namespace {

void append_little_endian(std::string& bytes, float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(bits >> shift & 0xffu);
}

}  // namespace

Image::Image(int width_, int height_, int channels_) : width(width_), height(height_), channels(channels_) {
  CHECK(width > 0 && height > 0, "an image of ", width, "x", height);
  CHECK(channels == 1 || channels == 3 || channels == 4, channels, " channels");
  pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                static_cast<std::size_t>(channels));
}

std::size_t Image::index(int x, int y) const {
  CHECK(x >= 0 && x < width && y >= 0 && y < height, "pixel ", x, ", ", y, " of ", width, "x", height);
  return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
         static_cast<std::size_t>(channels);
}

std::string encode_pfm(const Image& image) {
  CHECK(image.channels == 1 || image.channels == 3, image.channels, " channels");
  // A negative scale says little endian.
  std::string bytes = text_of(image.channels == 3 ? "PF" : "Pf", "\n", image.width, " ", image.height, "\n-1.0\n");
  bytes.reserve(bytes.size() + image.pixels.size() * sizeof(float));
  const int row_floats = image.width * image.channels;
  for (int y = image.height - 1; y >= 0; --y) {
    const float* row = image.at(0, y);
    for (int i = 0; i < row_floats; ++i) append_little_endian(bytes, row[i]);
  }
  return bytes;
}

}  // namespace terrella
