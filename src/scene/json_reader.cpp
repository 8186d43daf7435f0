#include "scene/json_reader.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "base/text.hpp"
#include "base/utf8.hpp"

namespace terrella {
namespace {

constexpr std::string_view kSpaces = " \t\r\n";
constexpr std::string_view kEndsOfWord = " \t\r\n,:{}[]\"";

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

// A name no longer than names are, so that a long one costs its length once and not for each member below it.
std::string kept_name(const std::string& name) {
  constexpr std::size_t kLongestName = 64;
  return name.size() <= kLongestName ? name : shortened(name);
}

class Reader {
 public:
  Reader(std::string_view text, const JsonForm& form) : text_(text), form_(form) {}

  JsonReading read() {
    if (text_.starts_with("\xef\xbb\xbf")) at_ = 3;  // a byte order mark
    skip_spaces();
    if (text_.empty() || at_ == text_.size()) {
      fail(text_of("The text is empty; a ", form_.what, " is a JSON object, at least {}."));
    } else if (peek() != '{') {
      fail(text_of("A ", form_.what, " is a JSON object, {…}, and this begins with \"",
                   shortened(text_.substr(at_), 20), "\"."));
    } else if (read_members("", Depth::Scene)) {
      skip_spaces();
      if (at_ < text_.size()) fail_here(text_of("the ", form_.what, " ends, but the text goes on"));
    }
    return std::move(reading_);
  }

 private:
  // Objects are read at two depths; what lies deeper is no scene's.
  enum class Depth { Scene, Group };

  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  void skip_spaces() { at_ = std::min(text_.find_first_not_of(kSpaces, at_), text_.size()); }

  bool accept(char c) {
    skip_spaces();
    if (peek() != c) return false;
    ++at_;
    return true;
  }

  void fail(std::string sentence) { reading_.trouble = std::move(sentence); }

  // Where, in lines and columns from 1, and what.
  bool fail_here(std::string_view what) {
    const std::string_view before = text_.substr(0, at_);
    const auto lines = std::count(before.begin(), before.end(), '\n');
    const std::size_t line_start = lines == 0 ? 0 : before.rfind('\n') + 1;
    fail(text_of("Line ", lines + 1, ", column ", at_ - line_start + 1, ": ", what, "; the rest was not read."));
    return false;
  }

  bool fail_expecting(std::string_view what) {
    if (at_ == text_.size()) return fail_here("the text breaks off");
    return fail_here(text_of(what, " should stand here, not \"", shortened(text_.substr(at_), 12), '"'));
  }

  // An object's members, from its '{' to its '}'.
  bool read_members(const std::string& prefix, Depth depth) {
    ++at_;
    if (accept('}')) return true;
    do {
      skip_spaces();
      if (peek() != '"') return fail_expecting("a name in quotes");
      const std::optional<std::string> name = read_string();
      if (!name) return false;
      if (!accept(':')) return fail_expecting("a colon");
      if (!read_member(prefix + kept_name(*name), depth)) return false;
    } while (accept(','));
    return accept('}') || fail_expecting("a comma or a closing brace");
  }

  bool read_member(const std::string& path, Depth depth) {
    skip_spaces();
    if (peek() == '{' && depth == Depth::Scene) return read_members(path + ".", Depth::Group);
    const bool is_list = depth == Depth::Scene && !form_.list.empty() && path == form_.list && peek() == '[';
    return is_list ? read_list(path) : read_entry(path, '}', "a comma or a closing brace", reading_.entries);
  }

  // A value that a comma or `end` follows. Only what follows shows that it is complete: 1 may be the beginning of 15.
  bool read_entry(const std::string& path, char end, std::string_view expected, std::vector<Entry>& entries) {
    std::optional<Entry> entry = read_value(path);
    if (!entry) return false;
    skip_spaces();
    if (peek() != ',' && peek() != end) return fail_expecting(expected);
    entries.push_back(std::move(*entry));
    return true;
  }

  // The form's list, from its '[' to its ']'. What its objects hold goes to their own entries.
  bool read_list(const std::string& path) {
    constexpr std::string_view kExpected = "a comma or a closing bracket";
    reading_.entries.push_back({path, "[…]", std::nullopt});
    ++at_;
    if (accept(']')) return true;
    do {
      skip_spaces();
      std::vector<Entry> item;
      const bool read = peek() == '{' ? read_object_into(item) : read_entry("", ']', kExpected, item);
      if (!read) return false;
      reading_.list.push_back(std::move(item));
    } while (accept(','));
    return accept(']') || fail_expecting(kExpected);
  }

  bool read_object_into(std::vector<Entry>& entries) {
    reading_.entries.swap(entries);
    const bool read = read_members("", Depth::Group);
    reading_.entries.swap(entries);
    return read;
  }

  std::optional<Entry> read_value(const std::string& path) {
    if (peek() == '{' || peek() == '[') return skip_nested(path);
    if (peek() != '"') return read_word(path);
    std::optional<std::string> text = read_string();
    if (!text) return std::nullopt;
    return Entry{path, *text, *text};
  }

  // A number, true, false, null, or what was meant as one.
  std::optional<Entry> read_word(const std::string& path) {
    const std::size_t end = std::min(text_.find_first_of(kEndsOfWord, at_), text_.size());
    const std::string_view word = text_.substr(at_, end - at_);
    if (word.empty()) {
      fail_expecting("a value");
      return std::nullopt;
    }
    at_ = end;
    Value value = kNoValue;
    if (word == "true" || word == "false") {
      value = word == "true";
    } else if (const auto number = parse_number(word)) {
      value = *number;
    }
    return Entry{path, std::string(word), value};
  }

  // Passes over a list or an object; only its beginning is kept, to be quoted.
  std::optional<Entry> skip_nested(const std::string& path) {
    const std::size_t start = at_;
    std::size_t open = 0;
    do {
      at_ = std::min(text_.find_first_of("{}[]\"", at_), text_.size());
      if (at_ == text_.size()) {
        fail_here("the text breaks off");
        return std::nullopt;
      }
      if (peek() == '"') {
        if (!read_string()) return std::nullopt;
        continue;
      }
      open += peek() == '{' || peek() == '[' ? std::size_t{1} : std::size_t(-1);
      ++at_;
    } while (open > 0);
    constexpr std::size_t kEnoughToQuote = 200;
    return Entry{path, std::string(text_.substr(start, std::min(at_ - start, kEnoughToQuote))), kNoValue};
  }

  // A string from its opening to its closing quote, its escapes resolved.
  std::optional<std::string> read_string() {
    std::string content;
    ++at_;
    while (true) {
      const std::size_t stop = std::min(text_.find_first_of("\"\\", at_), text_.size());
      content += text_.substr(at_, stop - at_);
      at_ = stop;
      if (at_ + 1 >= text_.size() && peek() != '"') {
        at_ = text_.size();
        fail_here("the text breaks off");
        return std::nullopt;
      }
      ++at_;
      if (text_[stop] == '"') return content;
      append_escaped(content);
    }
  }

  // What stands after a backslash. An escape that JSON does not have stands for its letter.
  void append_escaped(std::string& content) {
    constexpr std::string_view kLetters = "bfnrt", kMeanings = "\b\f\n\r\t";
    const char letter = text_[at_++];
    if (letter == 'u') {
      append_utf8(content, read_code_point());
      return;
    }
    const std::size_t index = kLetters.find(letter);
    content += index == std::string_view::npos ? letter : kMeanings[index];
  }

  // Characters beyond U+FFFF are escaped as a pair of surrogates.
  std::uint32_t read_code_point() {
    const std::uint32_t first = read_four_hex_digits();
    const bool high = first >= 0xd800 && first < 0xdc00;
    if (!high || text_.substr(at_, 2) != "\\u") return first;
    const std::size_t before_second = at_;
    at_ += 2;
    const std::uint32_t second = read_four_hex_digits();
    if (second >= 0xdc00 && second < 0xe000) return 0x10000 + ((first - 0xd800) << 10) + (second - 0xdc00);
    at_ = before_second;
    return first;
  }

  // Not a code point if there are no four digits.
  std::uint32_t read_four_hex_digits() {
    constexpr std::uint32_t kNone = 0xd800;
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::uint32_t code = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const char c = at_ + i < text_.size() ? text_[at_ + i] : '\0';
      const std::size_t digit = kDigits.find(c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c);
      if (digit == std::string_view::npos) return kNone;
      code = code << 4 | static_cast<std::uint32_t>(digit);
    }
    at_ += 4;
    return code;
  }

  std::string_view text_;
  JsonForm form_;
  std::size_t at_ = 0;
  JsonReading reading_;
};

}  // namespace

JsonReading read_json(std::string_view text, const JsonForm& form) { return Reader(text, form).read(); }

JsonReading read_given_json(std::string_view bytes, const JsonForm& form, Issues& issues) {
  if (bytes.size() > kLongestJson) {
    issues.add("",
               text_of("The ", form.what, " is ", bytes.size(), " bytes long; at most ", kLongestJson, " are read."));
    return {};
  }
  std::string repaired;
  const std::size_t not_utf8 = find_not_utf8(bytes);
  if (not_utf8 != std::string_view::npos) {
    issues.add("", text_of("The ", form.what, " is not UTF-8 text from byte ", not_utf8 + 1, " on."));
    bytes = repaired = repaired_utf8(bytes);
  }
  JsonReading reading = read_json(bytes, form);
  if (!reading.trouble.empty()) issues.add("", reading.trouble);
  return reading;
}

}  // namespace terrella
