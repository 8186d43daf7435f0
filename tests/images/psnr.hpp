#pragma once

#include <cmath>

#include "base/image.hpp"

namespace terrella::test {

// Peak signal to noise ratio, dB, of two pictures of one size and values whose peak is 1; 200 where they are equal.
inline double psnr(const Image& a, const Image& b) {
  double squares = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const double d = double{a.pixels[i]} - double{b.pixels[i]};
    squares += d * d;
  }
  return squares == 0.0 ? 200.0 : -10.0 * std::log10(squares / static_cast<double>(a.pixels.size()));
}

}  // namespace terrella::test
