// What can be seen on a screen.
#pragma once

#include <cstdint>
#include <vector>

namespace terrella::test {

struct Box {
  int left, top, width, height;
};

struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint32_t> pixels;  // 0xRRGGBB

  bool operator==(const Picture&) const = default;
};

// Mean of all channels in a part of a picture, 0 to 255.
double brightness(const Picture& picture, const Box& box);
// Mean difference of all channels, 0 to 255.
double difference(const Picture& a, const Picture& b, const Box& box);

}  // namespace terrella::test
