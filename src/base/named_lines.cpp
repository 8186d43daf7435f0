#include "base/named_lines.hpp"

#include <algorithm>

#include "base/text.hpp"

namespace terrella {
namespace {

// What lies before the next separator of a text, which is cut off with it; all where there is none.
std::string_view cut_off(std::string_view& text, char separator) {
  const std::size_t end = std::min(text.find(separator), text.size());
  const std::string_view before = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return before;
}

}  // namespace

void NamedLines::add(std::string_view name, std::string_view words) {
  text_ += name;
  text_ += ' ';
  for (const char c : words) text_ += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  text_ += '\n';
}

void NamedLines::add(std::string_view name, double number) { add(name, format_number(number)); }

double NamedLine::number() const { return parse_number(words).value_or(0.0); }

std::vector<NamedLine> lines_of(std::string_view text) {
  std::vector<NamedLine> lines;
  while (!text.empty()) {
    std::string_view words = cut_off(text, '\n');
    const std::string_view name = cut_off(words, ' ');
    lines.push_back({name, words});
  }
  return lines;
}

}  // namespace terrella
