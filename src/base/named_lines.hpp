// What one program tells another of its kind, as text: lines, each a name and what is said under it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace terrella {

class NamedLines {
 public:
  // Control characters among the words, of which one would end the line, become spaces.
  void add(std::string_view name, std::string_view words);
  void add(std::string_view name, double number);

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

struct NamedLine {
  std::string_view name, words;

  // What the words say where they are a number, else 0.
  [[nodiscard]] double number() const;
};

// The lines of a text, which must outlive them.
std::vector<NamedLine> lines_of(std::string_view text);

}  // namespace terrella
