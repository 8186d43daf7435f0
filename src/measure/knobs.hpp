// The knobs that trade speed for accuracy: a line each, and nothing else knows which there are or how many.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/parameters.hpp"

namespace terrella {

struct Knob {
  std::string_view path;      // of a parameter
  std::vector<Value> values;  // within its range, from the cheapest to the most accurate; two or more
  bool (*matters)(const Scene& scene) = [](const Scene&) { return true; };  // whether it can change anything
};

std::span<const Knob> knobs();

// The parameter that a knob turns.
const Parameter& parameter_of(const Knob& knob);

// The values that are tried on a scene: those of the knob and the scene's own in its place among them. few: only the
// cheapest, the scene's own and the next finer one.
std::vector<Value> values_for(const Knob& knob, const Scene& scene, bool few);

// The scene with a knob at a value, which must be within its range.
Scene turned(Scene scene, const Knob& knob, const Value& value);

// What tells a setting from all others, whatever knobs are added to the table later: the knobs' parameters that differ
// from the program's defaults, by their names' order, as a link tells them ("quality.antialias=false&…"); "default"
// where none does.
std::string setting_id(const Scene& scene);

}  // namespace terrella
