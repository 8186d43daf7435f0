#include "scene/parameters.hpp"

#include <map>
#include <type_traits>

#include "base/check.hpp"
#include "base/text.hpp"

namespace terrella {
namespace {

constexpr Scale linear = Scale::Linear, logarithmic = Scale::Logarithmic;

std::vector<std::string_view> split_names(std::string_view names) {
  std::vector<std::string_view> split;
  for (std::size_t bar = 0; bar != std::string_view::npos;) {
    bar = names.find('|');
    split.push_back(names.substr(0, bar));
    if (bar != std::string_view::npos) names.remove_prefix(bar + 1);
  }
  return split;
}

// A line of params.inc as plain data: code that makes a parameter of each would be 4 kB more of the page's
// download.
struct Row {
  const char* path;
  Type type;
  std::size_t offset;
  double min, max, slider_max;
  Scale scale;
  const char *unit, *choices, *help;
};

#define ROW(group, name, type) "" #group "." #name, Type::type, offsetof(Scene, group.name)

constexpr Row rows[] = {
#define GROUP(group, title, help)
#define FLOAT(group, name, value, min, max, unit, scale, help) \
  {ROW(group, name, Float), min, max, 0, scale, unit, "", help},
#define LENGTH(group, name, value, min, max, slider_max, scale, help) \
  {ROW(group, name, Float), min, max, slider_max, scale, "m", "", help},
#define INT(group, name, value, min, max, help) {ROW(group, name, Int), min, max, 0, linear, "", "", help},
#define BOOL(group, name, value, help) {ROW(group, name, Bool), 0, 0, 0, linear, "", "", help},
#define COLOR(group, name, value, help) {ROW(group, name, Color), 0, 0, 0, linear, "", "", help},
#define CHOICE(group, name, value, choices, help) {ROW(group, name, Choice), 0, 0, 0, linear, "", choices, help},
#define FILE_NAME(group, name, help) {ROW(group, name, File), 0, 0, 0, linear, "", "", help},
#define END_GROUP(group)
#include "scene/params.inc"
};
#include "scene/params_undef.inc"

Parameter parameter_of(const Row& row) {
  const std::string_view path = row.path;
  const std::size_t dot = path.find('.');
  Parameter parameter{path.substr(0, dot),
                      path.substr(dot + 1),
                      path,
                      row.type,
                      {},
                      row.min,
                      row.max,
                      row.slider_max,
                      row.unit,
                      row.scale,
                      {},
                      row.help,
                      row.offset};
  if (row.type == Type::Choice) {
    parameter.choices = split_names(row.choices);
    parameter.max = static_cast<double>(parameter.choices.size() - 1);
  }
  parameter.default_value = parameter.get(Scene{});
  return parameter;
}

#define GROUP(group, title, help) {#group, title, help},
#define FLOAT(group, name, value, min, max, unit, scale, help)
#define LENGTH(group, name, value, min, max, slider_max, scale, help)
#define INT(group, name, value, min, max, help)
#define BOOL(group, name, value, help)
#define COLOR(group, name, value, help)
#define CHOICE(group, name, value, choices, help)
#define FILE_NAME(group, name, help)
#define END_GROUP(group)
constexpr Group kGroups[] = {
#include "scene/params.inc"
};
#include "scene/params_undef.inc"

std::map<std::string_view, const Parameter*> index_by_path() {
  std::map<std::string_view, const Parameter*> by_path;
  for (const Parameter& parameter : parameters()) by_path[parameter.path] = &parameter;
  return by_path;
}

}  // namespace

std::span<const Parameter> parameters() {
  static const std::vector<Parameter> table = [] {
    std::vector<Parameter> made;
    for (const Row& row : rows) made.push_back(parameter_of(row));
    return made;
  }();
  return table;
}

std::span<const Group> groups() { return kGroups; }

Scene scaled(Scene scene, double factor) {
  for (const Parameter& parameter : parameters()) {
    if (parameter.unit == "m" || parameter.unit == "m/s") *std::get<double*>(parameter.field(scene)) *= factor;
  }
  return scene;
}

const Parameter* find_parameter(std::string_view path) {
  static const std::map<std::string_view, const Parameter*> by_path = index_by_path();
  const auto found = by_path.find(path);
  return found == by_path.end() ? nullptr : found->second;
}

const Group* find_group(std::string_view name) {
  for (const Group& group : groups()) {
    if (group.name == name) return &group;
  }
  return nullptr;
}

Field Parameter::field(Scene& scene) const {
  void* const place = reinterpret_cast<std::byte*>(&scene) + offset;
  switch (type) {
    case Type::Float: return static_cast<double*>(place);
    case Type::Bool: return static_cast<bool*>(place);
    case Type::Color: return static_cast<Color*>(place);
    case Type::File: return static_cast<MapFile*>(place);
    case Type::Int:
    case Type::Choice: break;
  }
  return static_cast<int*>(place);
}

Value Parameter::get(const Scene& scene) const {
  // Only read through: `field` serves reading and writing.
  const Field place = field(const_cast<Scene&>(scene));
  if (type == Type::Choice) return std::string(choices.at(static_cast<std::size_t>(*std::get<int*>(place))));
  return std::visit(
      [](auto* held) -> Value {
        if constexpr (std::is_same_v<decltype(held), MapFile*>)
          return held->name;
        else
          return *held;
      },
      place);
}

std::string_view choice_name(const Scene& scene, std::string_view path) {
  const Parameter* parameter = find_parameter(path);
  CHECK(parameter != nullptr && parameter->type == Type::Choice, path, " is not a choice");
  const int index = *std::get<int*>(parameter->field(const_cast<Scene&>(scene)));
  return parameter->choices.at(static_cast<std::size_t>(index));
}

}  // namespace terrella
