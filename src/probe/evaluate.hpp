// The bodies of the probe's functions on the CPU.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "base/height_map.hpp"

namespace terrella::probe {

// At most so many numbers are answered.
inline constexpr std::size_t kMostAnswers = 8;
template <class Real>
using Answers = std::array<Real, kMostAnswers>;

// Computes a function in single or in double precision from the numbers that its `prepare` made. What is not answered
// is 0. There must be such a function. map: null where it reads none.
Answers<float> evaluate_f32(std::string_view function, std::span<const float> numbers, const HeightMap* map = nullptr);
Answers<double> evaluate_f64(std::string_view function, std::span<const double> numbers,
                             const HeightMap* map = nullptr);

// What reads the library's structs from the numbers, as functions of GLSL that bodies call.
std::string_view readers_text();

// A function's body as GLSL, the inside of a function without arguments.
std::string_view body_text(std::string_view function);

}  // namespace terrella::probe
