#include "panel/quantity.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/text.hpp"

namespace terrella {
namespace {

struct LengthUnit {
  std::string_view name;
  double metres;
};

// From large to small; the last two are other spellings.
constexpr LengthUnit length_units[] = {{"km", 1e3},       {"m", 1.0},   {"mm", 1e-3},
                                       {"\u00b5m", 1e-6}, {"um", 1e-6}, {"cm", 1e-2}};
constexpr std::size_t units_shown = 4;

bool is_metric(const Parameter& parameter) { return parameter.unit == "m" || parameter.unit == "m/s"; }

LengthUnit unit_for(double metres) {
  if (metres == 0.0) return {"m", 1.0};
  for (std::size_t i = 0; i < units_shown; ++i) {
    if (std::abs(metres) >= length_units[i].metres) return length_units[i];
  }
  return length_units[units_shown - 1];
}

std::string with_unit(const std::string& number, const Parameter& parameter, double value) {
  if (is_metric(parameter)) return text_of(number, ' ', unit_for(value).name, parameter.unit.substr(1));
  if (parameter.unit == "deg") return text_of(number, "\u00b0");
  return parameter.unit.empty() ? number : text_of(number, ' ', parameter.unit);
}

double in_shown_unit(const Parameter& parameter, double value) {
  return is_metric(parameter) ? value / unit_for(value).metres : value;
}

std::string printed(const char* format, double value) {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

bool ends_a_number(char c) { return (c >= '0' && c <= '9') || c == '.'; }

}  // namespace

std::string short_number(double value) {
  const double size = std::abs(value);
  return printed(size >= 1e4 && size < 1e8 ? "%.0f" : "%.4g", value);
}

std::string quantity_text(const Parameter& parameter, double value) {
  return with_unit(short_number(in_shown_unit(parameter, value)), parameter, value);
}

std::string quantity_to_edit(const Parameter& parameter, double value) {
  return with_unit(printed("%.12g", in_shown_unit(parameter, value)), parameter, value);
}

std::optional<double> parse_quantity(std::string_view typed, const Parameter& parameter, double shown) {
  typed = trimmed(typed);
  // It may begin with a digit itself: 1/m.
  if (!is_metric(parameter) && typed.ends_with(text_of(' ', parameter.unit)))
    typed = trimmed(typed.substr(0, typed.size() - parameter.unit.size()));
  std::size_t digits = typed.size();
  while (digits > 0 && !ends_a_number(typed[digits - 1])) --digits;
  const std::optional<double> number = parse_typed_number(typed.substr(0, digits));
  if (!number || std::isnan(*number)) return std::nullopt;
  double value = *number;
  if (is_metric(parameter)) {
    const std::string_view unit = trimmed(typed.substr(digits));
    double metres = unit_for(shown).metres;
    for (const LengthUnit& known : length_units) {
      if (unit.substr(0, unit.find('/')) == known.name) metres = known.metres;
    }
    value *= metres;
  }
  return value;
}

std::optional<double> read_quantity(std::string_view typed, const Parameter& parameter, double shown) {
  std::optional<double> value = parse_quantity(typed, parameter, shown);
  if (!value) return std::nullopt;
  if (parameter.type == Type::Int) value = std::round(*value);
  return std::clamp(*value, parameter.min, parameter.max);
}

}  // namespace terrella
