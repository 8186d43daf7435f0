#include "measure/thumbnail.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "base/check.hpp"

namespace terrella {
namespace {

// Where a pixel of a smaller picture begins in the larger one.
int first_of(int at, int small, int large) { return static_cast<int>(static_cast<long long>(at) * large / small); }

// sRGB, chosen so that lightness (L*) rises by about the same from each to the next.
constexpr float stops[][3] = {{0.00F, 0.00F, 0.02F}, {0.19F, 0.06F, 0.38F}, {0.46F, 0.11F, 0.51F},
                              {0.72F, 0.21F, 0.47F}, {0.94F, 0.38F, 0.36F}, {0.99F, 0.63F, 0.43F},
                              {0.99F, 0.99F, 0.75F}};

}  // namespace

Image thumbnail(const Image& picture, int most_width) {
  if (picture.width <= most_width) return picture;
  const int width = most_width, height = std::max(1, (picture.height * width + picture.width / 2) / picture.width);
  Image small(width, height, picture.channels);
  for (int y = 0; y < height; ++y) {
    const int top = first_of(y, height, picture.height), bottom = first_of(y + 1, height, picture.height);
    for (int x = 0; x < width; ++x) {
      const int left = first_of(x, width, picture.width), right = first_of(x + 1, width, picture.width);
      const float share = 1.0F / static_cast<float>((right - left) * (bottom - top));
      for (int v = top; v < bottom; ++v) {
        for (int u = left; u < right; ++u) {
          for (int c = 0; c < picture.channels; ++c) small.at(x, y)[c] += share * picture.at(u, v)[c];
        }
      }
    }
  }
  return small;
}

Image heat(const Image& values, double most) {
  CHECK(values.channels == 1, values.channels, " channels");
  constexpr double last = static_cast<double>(std::size(stops) - 1);
  Image colors(values.width, values.height, 3);
  for (int y = 0; y < values.height; ++y) {
    for (int x = 0; x < values.width; ++x) {
      const double place = last * std::clamp(double{*values.at(x, y)} / most, 0.0, 1.0);
      const auto low = static_cast<std::size_t>(std::min(place, last - 1.0));
      const auto part = static_cast<float>(place - static_cast<double>(low));
      for (std::size_t c = 0; c < 3; ++c) colors.at(x, y)[c] = std::lerp(stops[low][c], stops[low + 1][c], part);
    }
  }
  return colors;
}

}  // namespace terrella
