// What several formulas of the picture are told.
#pragma once

#include <functional>
#include <span>

#include "probe/formula.hpp"

namespace terrella::probe {

inline constexpr Range components{-1.0, 1.0}, parts{0.0, 1.0};
inline constexpr Range seeds{0.0, 4294967295.0};
inline constexpr Range tops{1.0 + 1e-4, 2.0};  // of the air
inline constexpr Range brightness{0.0, 100.0};

// Radii: a thousandth of a metre over a planet of a kilometre, and as far away as a planet is a point.
inline constexpr double nearest_eye = 1e-6, farthest_eye = 1e3;

Arg air_shell();
Arg scene_argument();

// Puts the eye of a scene that was made up outside of the planet, mostly near it, and tells how high it is.
void place_eye(Json& scene, Random& random);

// The most light that there is in a scene, for Formula::made_from. scene: where it begins in the numbers.
std::function<double(std::span<const double>)> brightest_of_scene(std::size_t scene);

// A vector of any length as a unit vector.
Json unit(const glm::dvec3& v);

}  // namespace terrella::probe
