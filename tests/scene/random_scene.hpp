#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "scene/document.hpp"
#include "scene/parameters.hpp"
#include "scene/presets.hpp"

// Scenes to test with: every value within its range, all bits of it in use, the ends of the range now and then.
namespace terrella {

using Random = std::mt19937_64;

inline int random_int(Random& random, int from, int to) { return std::uniform_int_distribution(from, to)(random); }

inline double random_number(const Parameter& parameter, Random& random) {
  switch (random_int(random, 0, 9)) {
    case 0: return parameter.min;
    case 1: return parameter.max;
    default: break;
  }
  std::uniform_real_distribution<double> part(0, 1);
  const bool over_decades = parameter.min > 0 && parameter.scale == Scale::Logarithmic;
  const double value = over_decades ? parameter.min * std::pow(parameter.max / parameter.min, part(random))
                                    : std::lerp(parameter.min, parameter.max, part(random));
  return std::clamp(value, parameter.min, parameter.max);
}

// Of a file: with all that texts have to escape.
inline std::string random_name(Random& random) {
  constexpr std::string_view kPieces[] = {"earth", " ",  "&", "#",      "%41", "=",   "+",
                                          "\"",    "\\", "/", "\u00e9", "?",   ".png"};
  std::string name;
  for (int i = random_int(random, 0, 5); i > 0; --i) {
    name += kPieces[static_cast<std::size_t>(random_int(random, 0, static_cast<int>(std::size(kPieces)) - 1))];
  }
  return name;
}

inline void randomize(Scene& scene, const Parameter& parameter, Random& random) {
  const Field field = parameter.field(scene);
  if (auto* const* number = std::get_if<double*>(&field)) **number = random_number(parameter, random);
  if (auto* const* flag = std::get_if<bool*>(&field)) **flag = random_int(random, 0, 1) == 1;
  if (auto* const* color = std::get_if<Color*>(&field)) {
    **color = Color::from_hex(static_cast<std::uint32_t>(random_int(random, 0, 0xffffff)));
  }
  if (auto* const* whole = std::get_if<int*>(&field)) {
    **whole = random_int(random, static_cast<int>(parameter.min), static_cast<int>(parameter.max));
  }
  if (auto* const* file = std::get_if<MapFile*>(&field)) **file = {random_name(random), nullptr};
}

// Starts from any preset and changes anything from nothing to everything.
inline SceneDocument random_document(Random& random) {
  const auto last = static_cast<int>(presets().size()) - 1;
  const Preset& preset = presets()[static_cast<std::size_t>(random_int(random, 0, last))];
  SceneDocument document{preset.scene, preset.name};
  const int tenths_changed = random_int(random, 0, 10);
  for (const Parameter& parameter : parameters()) {
    if (random_int(random, 1, 10) <= tenths_changed) randomize(document.scene, parameter, random);
  }
  return document;
}

}  // namespace terrella
