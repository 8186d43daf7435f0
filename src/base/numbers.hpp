// What is asked of lists of numbers, such as the pixels of a picture.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

namespace terrella {

template <class Numbers>
bool all_finite(const Numbers& numbers) {
  return std::all_of(std::begin(numbers), std::end(numbers), [](auto number) { return std::isfinite(number); });
}

// Largest difference between any two numbers of two lists; infinite where their sizes differ or one is not a number.
double largest_difference(std::span<const float> a, std::span<const float> b);

}  // namespace terrella
