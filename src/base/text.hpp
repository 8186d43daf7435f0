#pragma once

#include <concepts>
#include <optional>
#include <span>
#include <string>
#include <string_view>

// Numbers and sentences as text. std::to_chars and std::format are avoided: not every standard library this builds with
// has them for double. All functions assume the "C" locale, which the program never leaves.
namespace terrella {

// The shortest decimal text that reads back as the same double: 0.1, 6371000, 1e8, -2.5e-7. Non-finite values give
// "inf", "-inf" and "nan", which are not JSON.
std::string format_number(double value);

// At most so many significant digits, as printf has it: 0.123, 1e+08, inf.
std::string printed_number(double value, int digits);

// Reads a number as JSON writes it, and nothing else: no spaces, no leading '+', no hexadecimal, no "nan". A number too
// large for a double gives an infinity, so that a range check can name it.
std::optional<double> parse_number(std::string_view text);

// The same as people type it: also with a leading '+', without a zero before the point or digits behind it.
std::optional<double> parse_typed_number(std::string_view text);

// The text made fit to be quoted in a sentence: at most max_length characters of it, an ellipsis where it was cut, and
// spaces for control characters.
std::string shortened(std::string_view text, std::size_t max_length = 40);

// A name as one says it: "ridge_sharpness" as "ridge sharpness".
std::string in_words(std::string_view name);

// "fast, balanced, high"
std::string listed(std::span<const std::string_view> names);

// The text in double quotes, escaped as JSON asks. The text must be UTF-8.
std::string json_quoted(std::string_view text);

inline std::string piece_of_text(std::string_view value) { return std::string(value); }
inline std::string piece_of_text(const char* value) { return value; }
inline std::string piece_of_text(char value) { return std::string(1, value); }
inline std::string piece_of_text(bool value) { return value ? "true" : "false"; }
inline std::string piece_of_text(double value) { return format_number(value); }
template <std::integral T>
std::string piece_of_text(T value) {
  return std::to_string(value);
}

// Its arguments one after the other: text_of("at most ", 8, " waves").
template <class... Pieces>
std::string text_of(const Pieces&... pieces) {
  std::string text;
  (text.append(piece_of_text(pieces)), ...);
  return text;
}

}  // namespace terrella
