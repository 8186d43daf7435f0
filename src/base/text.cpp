#include "base/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "base/utf8.hpp"

namespace terrella {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

// printf's exponent has a sign and two digits or more: 1e+08 becomes 1e8, 1e-06 becomes 1e-6.
std::string without_exponent_padding(const std::string& printed) {
  const std::size_t e = printed.find('e');
  if (e == std::string::npos) return printed;
  std::string shorter = printed.substr(0, e + 1);
  std::size_t digit = e + 1;
  if (printed[digit] == '-') shorter += '-';
  ++digit;
  while (digit + 1 < printed.size() && printed[digit] == '0') ++digit;
  return shorter + printed.substr(digit);
}

// A whole number of many zeros reads better with an exponent: 100000000 becomes 1e8, 6371000 stays.
std::string with_zeros_counted(const std::string& printed) {
  constexpr std::size_t kFewestZeros = 5;
  const std::size_t first = printed.starts_with('-') ? 1 : 0;
  const std::size_t last = printed.find_last_not_of('0');
  if (last == std::string::npos || printed.size() - 1 - last < kFewestZeros) return printed;
  if (printed.find_first_of(".en") != std::string::npos) return printed;
  const std::string fraction = printed.substr(first + 1, last - first);
  return text_of(printed.substr(0, first + 1), fraction.empty() ? "" : ".", fraction, 'e', printed.size() - first - 1);
}

// Whether the text is a number by JSON's grammar.
bool is_json_number(std::string_view text) {
  std::size_t at = 0;
  const auto digits = [&] {
    const std::size_t start = at;
    while (at < text.size() && is_digit(text[at])) ++at;
    return at - start;
  };
  if (at < text.size() && text[at] == '-') ++at;
  const bool leading_zero = at < text.size() && text[at] == '0';
  const std::size_t whole = digits();
  if (whole == 0 || (leading_zero && whole > 1)) return false;
  if (at < text.size() && text[at] == '.') {
    ++at;
    if (digits() == 0) return false;
  }
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    ++at;
    if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
    if (digits() == 0) return false;
  }
  return at == text.size();
}

}  // namespace

std::string printed_number(double value, int digits) {
  std::array<char, 40> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
  return buffer.data();
}

std::string format_number(double value) {
  if (!std::isfinite(value)) return std::isnan(value) ? "nan" : value < 0 ? "-inf" : "inf";
  constexpr int kEnoughDigits = 17;  // always reads back as the same double
  std::string printed;
  for (int digits = 15; digits <= kEnoughDigits; ++digits) {
    printed = printed_number(value, digits);
    if (std::strtod(printed.c_str(), nullptr) == value) break;
  }
  return with_zeros_counted(without_exponent_padding(printed));
}

std::optional<double> parse_number(std::string_view text) {
  if (!is_json_number(text)) return std::nullopt;
  return std::strtod(std::string(text).c_str(), nullptr);
}

std::optional<double> parse_typed_number(std::string_view text) {
  const bool plus = text.starts_with('+') && !text.starts_with("+-");
  std::string number(text.substr(plus ? 1 : 0));
  const std::size_t first = number.starts_with('-') ? 1 : 0, point = number.find('.');
  if (point == std::string::npos) return parse_number(number);
  const bool digits_follow = point + 1 < number.size() && is_digit(number[point + 1]);
  if (point == first && !digits_follow) return std::nullopt;
  if (!digits_follow) number.insert(point + 1, 1, '0');
  if (point == first) number.insert(point, 1, '0');
  return parse_number(number);
}

std::string shortened(std::string_view text, std::size_t max_length) {
  std::string kept;
  std::size_t at = 0;
  for (std::size_t length = 0; at < text.size() && length < max_length; ++length) {
    const std::size_t size = utf8_length(text.substr(at));
    if (size == 0) {
      kept += '?';
      ++at;
    } else if (is_control(text[at])) {
      kept += ' ';
      ++at;
    } else {
      kept += text.substr(at, size);
      at += size;
    }
  }
  if (at < text.size()) kept += "…";
  return kept;
}

std::string in_words(std::string_view name) {
  std::string words(name);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::string listed(std::span<const std::string_view> names) {
  std::string list;
  for (const std::string_view name : names) list += text_of(list.empty() ? "" : ", ", name);
  return list;
}

std::string json_quoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (is_control(c)) {
      std::array<char, 8> escape{};
      std::snprintf(escape.data(), escape.size(), "\\u%04x", static_cast<unsigned>(c));
      quoted += escape.data();
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

}  // namespace terrella
