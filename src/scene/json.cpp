#include "scene/json.hpp"

#include <array>
#include <cmath>

#include "base/check.hpp"
#include "base/text.hpp"
#include "scene/entries.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

// What a preset's file says about itself.
constexpr std::array<std::string_view, 2> kNotOurs = {"title", "about"};

}  // namespace

std::string json_value(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) CHECK(std::isfinite(*number), *number);
  const bool bare = std::holds_alternative<double>(value) || std::holds_alternative<int>(value) ||
                    std::holds_alternative<bool>(value);
  return bare ? to_text(value) : json_quoted(to_text(value));
}

std::string to_json(const SceneDocument& document) {
  const Preset* preset = find_preset(document.preset);
  CHECK(preset != nullptr, document.preset);
  std::string json = text_of("{\"terrella\":", kSceneVersion);
  if (document.preset != kDefaultPreset) json += text_of(",\"preset\":", json_quoted(document.preset));
  std::string_view open_group;  // whose members are being written
  for (const Parameter& parameter : parameters()) {
    const Value value = parameter.get(document.scene);
    if (value == parameter.get(preset->scene)) continue;
    if (parameter.group != open_group) {
      json += text_of(open_group.empty() ? "," : "},", json_quoted(parameter.group), ":{");
      open_group = parameter.group;
    } else {
      json += ',';
    }
    json += text_of(json_quoted(parameter.name), ':', json_value(value));
  }
  return json + (open_group.empty() ? "}" : "}}");
}

Issues load_json(SceneDocument& document, std::string_view text) {
  Issues issues;
  const JsonReading reading = read_given_json(text, {}, issues);
  apply_entries(document, reading.entries, kNotOurs, issues);
  return issues;
}

}  // namespace terrella
