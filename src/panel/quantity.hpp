// Numbers as the panel shows them and as people type them: "42.5 mm", "14°", "1.25 cells/radius".
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/parameters.hpp"

namespace terrella {

// At most four digits, with the parameter's unit. Lengths and speeds are told in the unit that fits their magnitude.
std::string quantity_text(const Parameter& parameter, double value);

// The same with all its digits, to be edited.
std::string quantity_to_edit(const Parameter& parameter, double value);

// What someone typed, in the parameter's own unit. A length may name its unit, "3 km"; a bare number counts in the unit
// in which `shown` is told. Nothing if it is not a number.
std::optional<double> parse_quantity(std::string_view typed, const Parameter& parameter, double shown);

// The same, held within the parameter's range.
std::optional<double> read_quantity(std::string_view typed, const Parameter& parameter, double shown);

// Any number, short: "12345", "0.123", "1.2e+09".
std::string short_number(double value);

}  // namespace terrella
