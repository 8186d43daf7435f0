// Maps of heights to test with.
#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include <glm/vec3.hpp>

#include "base/height_map.hpp"

namespace terrella::test {

// The middle of a texel.
inline glm::dvec3 direction_of_texel(int column, int row, int width, int height) {
  const double longitude = 2.0 * std::numbers::pi * ((column + 0.5) / width - 0.5);
  const double from_pole = std::numbers::pi * (row + 0.5) / height;
  return {std::sin(from_pole) * std::cos(longitude), std::sin(from_pole) * std::sin(longitude), std::cos(from_pole)};
}

// Hills without a seam or a pole, 0.1 to 0.9.
inline double smooth_height(const glm::dvec3& d) {
  return 0.5 + 0.2 * std::sin(5.0 * d.x + 1.0) * std::cos(4.0 * d.y - 2.0) + 0.2 * std::sin(3.0 * d.z + 4.0 * d.y);
}

inline SharedHeightMap smooth_map(int width, int height) {
  std::vector<float> heights;
  for (int i = 0; i < width * height; ++i) {
    heights.push_back(static_cast<float>(smooth_height(direction_of_texel(i % width, i / width, width, height))));
  }
  return std::make_shared<const HeightMap>(width, height, std::move(heights));
}

// Every texel by chance: as rough as a map can be.
inline SharedHeightMap rough_map(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<float> heights;
  for (int i = 0; i < width * height; ++i) heights.push_back(static_cast<float>(random() >> 8U) / 16777215.0F);
  return std::make_shared<const HeightMap>(width, height, std::move(heights));
}

}  // namespace terrella::test
