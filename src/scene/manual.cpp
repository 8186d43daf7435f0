#include "scene/manual.hpp"

#include <algorithm>
#include <string_view>

#include "base/text.hpp"
#include "scene/json.hpp"
#include "scene/parameters.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

constexpr std::string_view kIntroduction =
    "# Terrella's parameters\n\n"
    "Every parameter of a scene. In a scene's JSON they stand by group, `{\"terrella\": 1, \"waves\": {\"count\": "
    "8}}`; in "
    "a\nlink and on the command line flat, `waves.count=8`. Lengths are in metres. Where a scene starts from a preset, "
    "the\npreset's values take the place of the defaults below.\n";

std::string_view type_name(Type type) {
  switch (type) {
    case Type::Float: return "float";
    case Type::Int: return "int";
    case Type::Bool: return "bool";
    case Type::Color: return "color";
    case Type::File: return "file";
    case Type::Choice: break;
  }
  return "choice";
}

bool has_range(const Parameter& parameter) { return parameter.type == Type::Float || parameter.type == Type::Int; }

// The cell of a table that says what a parameter may be; for a bool the type says it.
std::string range_cell(const Parameter& parameter) {
  if (has_range(parameter)) return text_of(parameter.min, " to ", parameter.max);
  return parameter.type == Type::Choice ? allowed_values(parameter) : std::string();
}

std::string json_of(const Parameter& parameter) {
  std::string choices;
  for (const std::string_view name : parameter.choices) {
    choices += text_of(choices.empty() ? "" : ", ", json_quoted(name));
  }
  const auto limit = [&](double value) { return has_range(parameter) ? format_number(value) : "null"; };
  return text_of("{\"path\": ", json_quoted(parameter.path), ", \"type\": ", json_quoted(type_name(parameter.type)),
                 ", \"default\": ", json_value(parameter.default_value), ", \"min\": ", limit(parameter.min),
                 ", \"max\": ", limit(parameter.max), ", \"unit\": ", json_quoted(parameter.unit), ", \"choices\": [",
                 choices, "], \"help\": ", json_quoted(parameter.help), "}");
}

// A JSON list with an item a line.
template <class Items, class JsonOf>
std::string json_list(const Items& items, JsonOf json_of_item) {
  std::string list;
  for (const auto& item : items) list += text_of(list.empty() ? "[" : ",\n ", json_of_item(item));
  return list + "]\n";
}

}  // namespace

std::string manual_text() {
  std::string text(kIntroduction);
  for (const Group& group : groups()) {
    text += text_of("\n## ", group.title, "\n\n", group.help, ".\n\n",
                    "| parameter | type | default | range | unit | help |\n| --- | --- | --- | --- | --- | --- |\n");
    for (const Parameter& parameter : parameters()) {
      if (parameter.group != group.name) continue;
      text += text_of("| `", parameter.path, "` | ", type_name(parameter.type), " | ", to_text(parameter.default_value),
                      " | ", range_cell(parameter), " | ", parameter.unit, " | ", parameter.help, " |\n");
    }
  }
  return text;
}

std::string manual_json() { return json_list(parameters(), json_of); }

std::string presets_text() {
  std::size_t widest = 0;
  for (const Preset& preset : presets()) widest = std::max(widest, preset.name.size());
  std::string text;
  for (const Preset& preset : presets()) {
    const std::string padding(widest - preset.name.size() + 2, ' ');
    text += text_of(preset.name, padding, preset.title, ". ", preset.about, ".\n");
  }
  return text;
}

std::string presets_json() {
  return json_list(presets(), [](const Preset& preset) {
    return text_of("{\"name\": ", json_quoted(preset.name), ", \"title\": ", json_quoted(preset.title),
                   ", \"radius\": ", preset.scene.planet.radius, "}");
  });
}

}  // namespace terrella
