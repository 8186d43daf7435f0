#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace terrella {

// A picture of floats, rows from top to bottom, a pixel's channels side by side.
struct Image {
  int width = 0;
  int height = 0;
  int channels = 0;  // 1 (a quantity), 3 (colour or direction) or 4 (colour and opacity)
  std::vector<float> pixels;

  Image() = default;
  // All zero. width and height at least 1.
  Image(int width, int height, int channels);

  float* at(int x, int y) { return pixels.data() + index(x, y); }
  const float* at(int x, int y) const { return pixels.data() + index(x, y); }

 private:
  std::size_t index(int x, int y) const;
};

// The bytes of a portable float map: 1 or 3 channels, single precision, little endian, infinities kept.
std::string encode_pfm(const Image& image);

// The bytes of an 8 bit PNG: 3 or 4 channels that are sRGB already, 0 to 1; beyond that they are clamped, NaN is black.
// Desktop only.
std::string encode_png(const Image& image);

}  // namespace terrella
