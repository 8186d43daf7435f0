#include "window/picture.hpp"

#include <cstdlib>

namespace terrella::test {
namespace {

template <typename Value>
double mean(const Picture& picture, const Box& box, Value value_at) {
  double sum = 0.0;
  for (int y = box.top; y < box.top + box.height; ++y) {
    for (int x = box.left; x < box.left + box.width; ++x) {
      const auto i =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x);
      for (int shift = 0; shift < 24; shift += 8) sum += value_at(i, shift);
    }
  }
  return sum / (3.0 * box.width * box.height);
}

int channel(std::uint32_t pixel, int shift) { return static_cast<int>(pixel >> shift & 0xFFU); }

}  // namespace

double brightness(const Picture& picture, const Box& box) {
  return mean(picture, box, [&](std::size_t i, int shift) { return channel(picture.pixels.at(i), shift); });
}

double difference(const Picture& a, const Picture& b, const Box& box) {
  return mean(a, box, [&](std::size_t i, int shift) {
    return std::abs(channel(a.pixels.at(i), shift) - channel(b.pixels.at(i), shift));
  });
}

}  // namespace terrella::test
