#include "probe/line.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/text.hpp"
#include "base/utf8.hpp"

namespace terrella::probe {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

// No request is nested deeper than a list in an object in a list of arguments; what is, would not be printed without
// recursion either.
constexpr int kDeepest = 64;

// The place after the string that begins at a place; the end of the text where the string has none.
std::size_t end_of_string(std::string_view text, std::size_t start) {
  for (std::size_t i = start + 1; i < text.size(); ++i) {
    if (text[i] == '\\') {
      ++i;
    } else if (text[i] == '"') {
      return i + 1;
    }
  }
  return text.size();
}

// Calls visit(place, depth) for the beginning of each string and for each other character, with how many lists and
// objects are open before it, until visit returns false.
template <class Visit>
void walk(std::string_view text, const Visit& visit) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size();) {
    if (!visit(i, depth)) return;
    const char c = text[i];
    if (c == '{' || c == '[') ++depth;
    if (c == '}' || c == ']') --depth;
    i = c == '"' ? end_of_string(text, i) : i + 1;
  }
}

bool too_deep(std::string_view text) {
  bool deep = false;
  walk(text, [&](std::size_t i, int depth) {
    deep = depth == kDeepest && (text[i] == '{' || text[i] == '[');
    return !deep;
  });
  return deep;
}

// A text from its beginning to the comma or bracket that ends its first value; empty where nothing ends it, for then
// nobody knows what is missing.
std::string_view first_value(std::string_view text) {
  std::string_view value;
  walk(text, [&](std::size_t i, int depth) {
    if (depth > 0 || (text[i] != ',' && text[i] != '}' && text[i] != ']')) return true;
    value = text.substr(0, i);
    return false;
  });
  return value;
}

// The id of what may be a broken object.
Json id_within(std::string_view line) {
  Json id;
  const std::size_t first = line.find_first_not_of(kBlanks);
  if (first == std::string_view::npos || line[first] != '{') return id;
  walk(line, [&](std::size_t i, int depth) {
    constexpr std::string_view name = "\"id\"";
    if (depth != 1 || line.substr(i, name.size()) != name) return true;
    const std::size_t colon = line.find_first_not_of(kBlanks, i + name.size());
    if (colon == std::string_view::npos || line[colon] != ':') return true;
    const std::string_view value = first_value(line.substr(colon + 1));
    if (!too_deep(value)) id = Json::parse(value, nullptr, false);
    if (id.is_discarded()) id = Json();
    return false;
  });
  return id;
}

// The first word outside of strings that JSON does not know, such as NaN, or a number too large for a double.
std::string_view unknown_word(std::string_view line) {
  constexpr std::string_view between = "{}[],:\" \t\r\n";
  std::string_view found;
  std::size_t end = 0;  // of the word looked at last
  walk(line, [&](std::size_t i, int) {
    if (i < end || between.find(line[i]) != std::string_view::npos) return true;
    end = std::min(line.find_first_of(between, i), line.size());
    const std::string_view word = line.substr(i, end - i);
    if (word == "null" || word == "true" || word == "false") return true;
    const auto number = parse_number(word);
    if (number && std::isfinite(*number)) return true;
    found = word;
    return false;
  });
  return found;
}

std::string why_no_json(std::string_view line) {
  if (find_not_utf8(line) != std::string_view::npos) return "The line is not UTF-8.";
  const std::string_view word = unknown_word(line);
  if (parse_number(word)) return text_of(shortened(word), " is too large; numbers are at most 1.797e308.");
  const std::size_t first = line.find_first_not_of(kBlanks);
  if (!word.empty() && line[first] == '{') {
    return text_of(json_quoted(shortened(word)), " is no value of JSON; numbers are finite and words stand in quotes.");
  }
  return "The line is not a JSON object, {\"fn\": …, \"args\": {…}, \"precision\": …}.";
}

}  // namespace

Line read_line(const std::string& line) {
  Line read;
  if (line.size() > kLongestLine) {
    read.trouble = text_of("The line is longer than ", kLongestLine, " bytes; no more are read.");
  } else if (too_deep(line)) {
    read.trouble = text_of("The line is nested deeper than ", kDeepest, " lists and objects.");
  } else {
    read.request = Json::parse(line, nullptr, false);
    if (read.request.is_discarded() || !read.request.is_object()) read.trouble = why_no_json(line);
  }
  read.id = read.trouble.empty() ? read.request.value("id", Json()) : id_within(line);
  return read;
}

}  // namespace terrella::probe
