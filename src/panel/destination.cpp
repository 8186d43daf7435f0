#include "panel/destination.hpp"

#include <cmath>
#include <vector>

#include "base/text.hpp"
#include "panel/quantity.hpp"

namespace terrella {
namespace {

std::vector<std::string_view> parts_of(std::string_view text) {
  const char separator = text.find(';') == std::string_view::npos ? ',' : ';';
  std::vector<std::string_view> parts;
  for (std::size_t at = 0;;) {
    const std::size_t end = text.find(separator, at);
    parts.push_back(text.substr(at, end - at));
    if (end == std::string_view::npos) return parts;
    at = end + 1;
  }
}

// Takes "S" or "W" from an angle. Returns the sign that it stands for.
double take_side(std::string_view& typed, std::string_view positive, std::string_view negative) {
  while (!typed.empty() && typed.back() == ' ') typed.remove_suffix(1);
  if (typed.empty()) return 1.0;
  const char last = typed.back();
  const bool is_negative = negative.find(last) != std::string_view::npos;
  if (!is_negative && positive.find(last) == std::string_view::npos) return 1.0;
  typed.remove_suffix(1);
  return is_negative ? -1.0 : 1.0;
}

// What is typed for one parameter; a sentence in `trouble` where that is not allowed.
double read_part(std::string_view typed, const char* path, double sign, double shown, std::string& trouble) {
  const Parameter& parameter = *find_parameter(path);
  const std::optional<double> number = parse_quantity(typed, parameter, shown);
  double value = number ? sign * *number : 0.0;
  if (parameter.name == "longitude" && std::abs(value) <= 360.0) value = std::remainder(value, 360.0);
  Scene unused;
  const auto issue = assign(unused, parameter, number ? Value(value) : Value(std::string(typed)));
  if (issue && trouble.empty()) trouble = issue->text();
  return value;
}

}  // namespace

std::variant<Destination, std::string> read_destination(std::string_view typed, double altitude) {
  std::vector<std::string_view> parts = parts_of(typed);
  if (parts.size() < 2 || parts.size() > 3) {
    return text_of("\"", shortened(typed),
                   "\" is no place: that is a latitude, a longitude and, if you like, an altitude, with commas between "
                   "them, as in \"47.5, 8.2, 3 km\".");
  }
  Destination there;
  std::string trouble;
  const double north = take_side(parts[0], "Nn", "Ss"), east = take_side(parts[1], "Ee", "Ww");
  there.latitude = read_part(parts[0], "camera.latitude", north, 0.0, trouble);
  there.longitude = read_part(parts[1], "camera.longitude", east, 0.0, trouble);
  if (parts.size() == 3) there.altitude = read_part(parts[2], "camera.altitude", 1.0, altitude, trouble);
  if (!trouble.empty()) return trouble;
  return there;
}

}  // namespace terrella
