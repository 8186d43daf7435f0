#include <png.h>

#include <cmath>
#include <vector>

#include "base/check.hpp"
#include "base/image.hpp"

namespace terrella {
namespace {

png_byte to_byte(float value) {
  if (!(value > 0)) return 0;  // NaN too
  if (value >= 1) return 255;
  return static_cast<png_byte>(value * 255.0f + 0.5f);
}

}  // namespace

std::string encode_png(const Image& image) {
  CHECK(image.channels == 3 || image.channels == 4, image.channels, " channels");
  std::vector<png_byte> samples;
  samples.reserve(image.pixels.size());
  for (const float value : image.pixels) samples.push_back(to_byte(value));

  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = image.channels == 3 ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;

  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string bytes(size, '\0');
  constexpr int kExactSamples = 0, kTightRows = 0;
  const int written =
      png_image_write_to_memory(&header, bytes.data(), &size, kExactSamples, samples.data(), kTightRows, nullptr);
  CHECK(written != 0, header.message);
  bytes.resize(size);
  return bytes;
}

}  // namespace terrella
