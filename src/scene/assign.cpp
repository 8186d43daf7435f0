#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "base/text.hpp"
#include "scene/parameters.hpp"

// How a user's value gets into a scene, or why it does not.
namespace terrella {
namespace {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

std::optional<double> number_in(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* number = std::get_if<int>(&value)) return *number;
  return std::nullopt;
}

std::optional<Color> color_in(const Value& value) {
  if (const auto* color = std::get_if<Color>(&value)) return *color;
  if (const auto* text = std::get_if<std::string>(&value)) return parse_color(*text);
  return std::nullopt;
}

// What is wrong with a number for this parameter; empty if nothing is.
std::string trouble_with_number(const Parameter& parameter, std::optional<double> number) {
  const bool whole = parameter.type == Type::Int;
  if (!number || std::isnan(*number)) return whole ? "is not a whole number" : "is not a number";
  if (*number < parameter.min || *number > parameter.max) return "is out of range";
  if (whole && *number != std::trunc(*number)) return "is not a whole number";
  return {};
}

std::string assign_number(Field field, const Parameter& parameter, const Value& value) {
  const std::optional<double> number = number_in(value);
  std::string trouble = trouble_with_number(parameter, number);
  if (!trouble.empty()) return trouble;
  if (parameter.type == Type::Int) {
    *std::get<int*>(field) = static_cast<int>(*number);
  } else {
    *std::get<double*>(field) = *number;
  }
  return {};
}

std::string assign_bool(Field field, const Value& value) {
  const auto* given = std::get_if<bool>(&value);
  if (given == nullptr) return "is neither true nor false";
  *std::get<bool*>(field) = *given;
  return {};
}

std::string assign_color(Field field, const Value& value) {
  const std::optional<Color> color = color_in(value);
  if (!color) return "is not a colour";
  *std::get<Color*>(field) = *color;
  return {};
}

std::string assign_choice(Field field, const Parameter& parameter, const Value& value) {
  const auto* name = std::get_if<std::string>(&value);
  if (name == nullptr) return "is not a choice";
  const auto found = std::find(parameter.choices.begin(), parameter.choices.end(), *name);
  if (found == parameter.choices.end()) return "is not a choice";
  *std::get<int*>(field) = static_cast<int>(found - parameter.choices.begin());
  return {};
}

bool is_file_name(std::string_view name) {
  const auto is_control = [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; };
  return name.size() <= longest_file_name && std::none_of(name.begin(), name.end(), is_control);
}

std::string assign_file(Field field, const Value& value) {
  const auto* name = std::get_if<std::string>(&value);
  if (name == nullptr || !is_file_name(*name)) return "is not the name of a file";
  MapFile& file = *std::get<MapFile*>(field);
  if (file.name != *name) file = {*name, nullptr};
  return {};
}

// Text in quotes, all else bare.
std::string quoted(const Value& value, std::string_view given) {
  return std::holds_alternative<std::string>(value) ? text_of('"', shortened(given), '"') : shortened(given);
}

Value value_of_text(const Parameter& parameter, std::string_view text) {
  if (parameter.type == Type::Float || parameter.type == Type::Int) {
    if (const auto number = parse_typed_number(text)) return *number;
  }
  if (parameter.type == Type::Bool) {
    if (text == "true" || text == "1") return true;
    if (text == "false" || text == "0") return false;
  }
  return std::string(text);
}

// What the sentence ends with, after what is allowed.
std::string hint(const Parameter& parameter, const Value& value) {
  const auto* name = std::get_if<std::string>(&value);
  if (parameter.type != Type::Choice || name == nullptr) return ".";
  return did_you_mean(nearest_name(*name, parameter.choices));
}

std::string_view nearest_path(std::string_view path) {
  std::vector<std::string_view> paths;
  for (const Parameter& parameter : parameters()) {
    if (parameter.name == path) return parameter.path;  // only the group is missing
    paths.push_back(parameter.path);
  }
  return nearest_name(path, paths);
}

}  // namespace

std::string to_text(const Value& value) {
  return std::visit(
      Overloaded{[](const Color& color) { return to_text(color); }, [](const auto& other) { return text_of(other); }},
      value);
}

std::string allowed_values(const Parameter& parameter) {
  switch (parameter.type) {
    case Type::Float:
    case Type::Int:
      return text_of(parameter.min, " to ", parameter.max, parameter.unit.empty() ? "" : " ", parameter.unit);
    case Type::Bool: return "true or false";
    case Type::Color: return "#000000 to #ffffff";
    case Type::File: return text_of("names of up to ", longest_file_name, " bytes, or none");
    case Type::Choice: break;
  }
  return listed(parameter.choices);
}

std::optional<Issue> assign(Scene& scene, const Parameter& parameter, const Value& value, std::string_view given) {
  const Field field = parameter.field(scene);
  std::string trouble;
  switch (parameter.type) {
    case Type::Float:
    case Type::Int: trouble = assign_number(field, parameter, value); break;
    case Type::Bool: trouble = assign_bool(field, value); break;
    case Type::Color: trouble = assign_color(field, value); break;
    case Type::File: trouble = assign_file(field, value); break;
    case Type::Choice: trouble = assign_choice(field, parameter, value); break;
  }
  if (trouble.empty()) return std::nullopt;
  return Issue{std::string(parameter.path), text_of(quoted(value, given), ' ', trouble, "; allowed are ",
                                                    allowed_values(parameter), hint(parameter, value))};
}

std::optional<Issue> assign(Scene& scene, const Parameter& parameter, const Value& value) {
  return assign(scene, parameter, value, to_text(value));
}

std::optional<Issue> assign_text(Scene& scene, std::string_view path, std::string_view text) {
  const Parameter* parameter = find_parameter(path);
  if (parameter == nullptr) return no_such_parameter(path);
  return assign(scene, *parameter, value_of_text(*parameter, text), text);
}

Issue no_such_parameter(std::string_view path) {
  const std::string shown = path.empty() ? "\"\"" : shortened(path);
  return {shown, text_of("there is no such parameter", did_you_mean(nearest_path(path)))};
}

}  // namespace terrella
