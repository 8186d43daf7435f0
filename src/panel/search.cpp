#include "panel/search.hpp"

#include <algorithm>

#include "base/text.hpp"

namespace terrella {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    if (end > at) words.push_back(lower(text.substr(at, end - at)));
    at = end + 1;
  }
  return words;
}

// All that is said about a parameter.
std::string said_of(const Parameter& parameter) {
  return lower(text_of(parameter.path, '\n', in_words(parameter.name), '\n', parameter.help, '\n',
                       find_group(parameter.group)->title));
}

}  // namespace

std::vector<const Parameter*> parameters_about(std::string_view text) {
  const std::vector<std::string> words = words_of(text);
  std::vector<const Parameter*> found;
  for (const Parameter& parameter : parameters()) {
    const std::string said = said_of(parameter);
    const auto occurs = [&](const std::string& word) { return said.find(word) != std::string::npos; };
    if (std::all_of(words.begin(), words.end(), occurs)) found.push_back(&parameter);
  }
  return found;
}

std::string nothing_about(std::string_view text) {
  std::vector<std::string> names;
  for (const Group& group : groups()) names.push_back(lower(group.title));
  for (const Parameter& parameter : parameters()) {
    names.push_back(in_words(parameter.name));
    names.emplace_back(parameter.path);
  }
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  return text_of("There is no \"", text, '"', did_you_mean(nearest_name(lower(text), candidates)));
}

}  // namespace terrella
