#include "probe/arguments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/issues.hpp"
#include "base/text.hpp"

namespace terrella::probe {
namespace {

// As a user wrote it, cut short.
std::string quoted(const Json& value) { return shortened(value.dump()); }

std::string names_of(std::span<const Arg> declared) {
  std::string names;
  for (std::size_t i = 0; i < declared.size(); ++i) {
    if (i > 0) names += i + 1 == declared.size() ? " and " : ", ";
    names += declared[i].name;
  }
  return names;
}

std::string in_unit(const Arg& arg) { return arg.unit.empty() ? std::string() : text_of(" (", arg.unit, ")"); }

std::string kind_in_words(const Arg& arg) {
  switch (arg.kind) {
    case Kind::number: return "a number" + in_unit(arg);
    case Kind::whole: return "a whole number";
    case Kind::triple: return "a list of three numbers" + in_unit(arg);
    case Kind::spread: return "a number or a list of three" + in_unit(arg);
    case Kind::pair: return "a list of two numbers" + in_unit(arg);
    case Kind::numbers: return text_of("a list of at most ", kLongestList, " numbers") + in_unit(arg);
    case Kind::word: break;
    case Kind::object: return text_of("an object with ", names_of(arg.fields));
    case Kind::objects: return text_of("a list of at most ", kLongestList, " objects with ", names_of(arg.fields));
  }
  std::string words = "one of";
  for (std::size_t i = 0; i < arg.words.size(); ++i) words += text_of(i > 0 ? ", " : " ", json_quoted(arg.words[i]));
  return words;
}

std::string wrong_kind(const Json& value, const Arg& arg, const std::string& name) {
  return text_of(name, ": ", quoted(value), " is not ", kind_in_words(arg), ".");
}

// A number within the range; whole ones also within what an int holds.
std::string trouble_with_number(const Json& value, const Arg& arg, const std::string& name) {
  if (!value.is_number()) return wrong_kind(value, arg, name);
  const double number = value.get<double>();
  const bool whole = arg.kind == Kind::whole;
  if (whole && std::floor(number) != number) return wrong_kind(value, arg, name);
  const Range& range = arg.range;
  const bool inside =
      range.open ? number > range.low && number < range.high : number >= range.low && number <= range.high;
  if (inside) return {};
  return text_of(name, ": ", quoted(value), " is out of range; allowed is ", range_in_words(range), ".");
}

std::string trouble_with_value(const Json& value, const Arg& arg, const std::string& name) {
  switch (arg.kind) {
    case Kind::number:
    case Kind::whole: return trouble_with_number(value, arg, name);
    case Kind::spread:
      if (value.is_number()) return trouble_with_number(value, arg, name);
      [[fallthrough]];
    case Kind::triple:
    case Kind::pair:
    case Kind::numbers: {
      const bool any_length = arg.kind == Kind::numbers;
      const std::size_t length = arg.kind == Kind::pair ? 2 : 3;
      if (!value.is_array() || (any_length ? value.size() > kLongestList : value.size() != length)) {
        return wrong_kind(value, arg, name);
      }
      for (std::size_t i = 0; i < value.size(); ++i) {
        Arg one = arg;
        one.kind = Kind::number;
        std::string trouble = trouble_with_number(value[i], one, text_of(name, "[", i, "]"));
        if (!trouble.empty()) return trouble;
      }
      return {};
    }
    case Kind::word: {
      if (!value.is_string()) return wrong_kind(value, arg, name);
      const auto& word = value.get_ref<const std::string&>();
      if (std::find(arg.words.begin(), arg.words.end(), word) != arg.words.end()) return {};
      return text_of(name, ": ", quoted(value), " is not ", kind_in_words(arg),
                     did_you_mean(nearest_name(word, arg.words)));
    }
    case Kind::object:
      if (!value.is_object()) return wrong_kind(value, arg, name);
      return trouble_with(value, arg.fields, name);
    case Kind::objects:
      if (!value.is_array() || value.size() > kLongestList) return wrong_kind(value, arg, name);
      for (std::size_t i = 0; i < value.size(); ++i) {
        const std::string one = text_of(name, "[", i, "]");
        if (!value[i].is_object()) return text_of(one, ": ", quoted(value[i]), " is not an object.");
        std::string trouble = trouble_with(value[i], arg.fields, one);
        if (!trouble.empty()) return trouble;
      }
      return {};
  }
  return {};
}

// All numbers in a value rounded; lists and objects may hold others.
void round_within(Json& value, bool on_gpu) {
  if (value.is_number()) {
    const double rounded = static_cast<double>(static_cast<float>(value.get<double>()));
    const bool lost = on_gpu && std::fabs(rounded) < static_cast<double>(std::numeric_limits<float>::min());
    value = lost ? 0.0 : rounded;
  } else if (value.is_structured()) {
    for (Json& one : value) round_within(one, on_gpu);
  }
}

}  // namespace

std::string range_in_words(const Range& range) {
  const bool from = std::isfinite(range.low), to = std::isfinite(range.high);
  if (from && to) {
    return range.open ? text_of("more than ", range.low, " and less than ", range.high)
                      : text_of(range.low, " to ", range.high);
  }
  if (from) return text_of(range.open ? "more than " : "at least ", range.low);
  if (to) return text_of(range.open ? "less than " : "at most ", range.high);
  return "any number";
}

std::string trouble_with_squares(const Json& object, std::span<const Arg> declared) {
  for (const Arg& arg : declared) {
    if (!arg.squared) continue;
    const Json& value = object[arg.name];
    double size = value.is_number() ? std::fabs(value.get<double>()) : 0.0;
    for (const Json& part : value.is_array() ? value : Json::array())
      size = std::max(size, std::fabs(part.get<double>()));
    if (size == 0.0 || (size >= squarable.low && size <= squarable.high)) continue;
    return text_of(arg.name, ": ", quoted(value), " is out of range; allowed is 0 or a size of ",
                   range_in_words(squarable), ".");
  }
  return {};
}

Json as_told(const Json& object, std::span<const Arg> declared, Precision precision) {
  Json told = object;
  for (const Arg& arg : declared) {
    const auto found = told.find(std::string(arg.name));
    if (found != told.end() && !arg.of_host) round_within(*found, precision == Precision::gpu && !arg.squared);
  }
  return told;
}

std::string trouble_with(const Json& object, std::span<const Arg> declared, std::string_view whole) {
  for (const auto& [name, value] : object.items()) {
    const auto same = [&name = name](const Arg& arg) { return arg.name == name; };
    if (std::any_of(declared.begin(), declared.end(), same)) continue;
    std::vector<std::string_view> names;
    for (const Arg& arg : declared) names.push_back(arg.name);
    const std::string_view nearest = nearest_name(name, names);
    return text_of(whole, ": there is no argument ", json_quoted(shortened(name)),
                   nearest.empty() ? text_of("; there is ", names_of(declared), ".") : did_you_mean(nearest));
  }
  for (const Arg& arg : declared) {
    const auto found = object.find(std::string(arg.name));
    if (arg.optional && (found == object.end() || found->is_null())) continue;
    if (found == object.end()) {
      return text_of(whole, ": the argument ", arg.name, " is missing; it is ", kind_in_words(arg), ".");
    }
    std::string trouble = trouble_with_value(*found, arg, std::string(arg.name));
    if (!trouble.empty()) return trouble;
  }
  return {};
}

}  // namespace terrella::probe
