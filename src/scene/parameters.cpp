#include "scene/parameters.hpp"

#include <unordered_map>

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

Parameter choice_parameter(std::string_view group, std::string_view name, std::string_view path, int default_index,
                           std::string_view names, std::string_view help, Field (*field)(Scene&)) {
  std::vector<std::string_view> choices = split_names(names);
  const std::string default_name(choices.at(static_cast<std::size_t>(default_index)));
  const double last = static_cast<double>(choices.size() - 1);
  return {group, name, path, Type::Choice, default_name, 0, last, 0, "", linear, std::move(choices), help, field};
}

#define NAMES(group, name) #group, #name, #group "." #name
#define FIELD(group, name) [](Scene& scene) -> Field { return &scene.group.name; }

#define GROUP(group, title, help)
#define FLOAT(group, name, value, min, max, unit, scale, help) \
  {NAMES(group, name), Type::Float, Value(value), min, max, 0, unit, scale, {}, help, FIELD(group, name)},
#define LENGTH(group, name, value, min, max, slider_max, scale, help) \
  {NAMES(group, name), Type::Float, Value(value), min, max, slider_max, "m", scale, {}, help, FIELD(group, name)},
#define INT(group, name, value, min, max, help) \
  {NAMES(group, name), Type::Int, Value(value), min, max, 0, "", linear, {}, help, FIELD(group, name)},
#define BOOL(group, name, value, help) \
  {NAMES(group, name), Type::Bool, Value(value), 0, 0, 0, "", linear, {}, help, FIELD(group, name)},
#define COLOR(group, name, value, help) \
  {NAMES(group, name), Type::Color, Value(Color::from_hex(value)), 0, 0, 0, "", linear, {}, help, FIELD(group, name)},
#define CHOICE(group, name, value, choices, help) \
  choice_parameter(NAMES(group, name), value, choices, help, FIELD(group, name)),
#define END_GROUP(group)
std::vector<Parameter> make_parameters() {
  return {
#include "scene/params.inc"
  };
}
#include "scene/params_undef.inc"

#define GROUP(group, title, help) {#group, title, help},
#define FLOAT(group, name, value, min, max, unit, scale, help)
#define LENGTH(group, name, value, min, max, slider_max, scale, help)
#define INT(group, name, value, min, max, help)
#define BOOL(group, name, value, help)
#define COLOR(group, name, value, help)
#define CHOICE(group, name, value, choices, help)
#define END_GROUP(group)
constexpr Group kGroups[] = {
#include "scene/params.inc"
};
#include "scene/params_undef.inc"

std::unordered_map<std::string_view, const Parameter*> index_by_path() {
  std::unordered_map<std::string_view, const Parameter*> by_path;
  for (const Parameter& parameter : parameters()) by_path[parameter.path] = &parameter;
  return by_path;
}

}  // namespace

std::span<const Parameter> parameters() {
  static const std::vector<Parameter> table = make_parameters();
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
  static const std::unordered_map<std::string_view, const Parameter*> by_path = index_by_path();
  const auto found = by_path.find(path);
  return found == by_path.end() ? nullptr : found->second;
}

const Group* find_group(std::string_view name) {
  for (const Group& group : groups()) {
    if (group.name == name) return &group;
  }
  return nullptr;
}

Value Parameter::get(const Scene& scene) const {
  // Only read through: `field` serves reading and writing.
  const Field place = field(const_cast<Scene&>(scene));
  if (type == Type::Choice) return std::string(choices.at(static_cast<std::size_t>(*std::get<int*>(place))));
  return std::visit([](auto* held) { return Value(*held); }, place);
}

std::string_view choice_name(const Scene& scene, std::string_view path) {
  const Parameter* parameter = find_parameter(path);
  CHECK(parameter != nullptr && parameter->type == Type::Choice, path, " is not a choice");
  const int index = *std::get<int*>(parameter->field(const_cast<Scene&>(scene)));
  return parameter->choices.at(static_cast<std::size_t>(index));
}

}  // namespace terrella
