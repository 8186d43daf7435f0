#include "base/json_text.hpp"

#include "base/text.hpp"

namespace terrella {

std::string json_object(std::initializer_list<std::pair<std::string_view, std::string>> members) {
  std::string json = "{";
  for (const auto& [name, value] : members) {
    if (!value.empty()) json += text_of(json.size() > 1 ? "," : "", '"', name, "\":", value);
  }
  return json + '}';
}

std::string json_list(const std::vector<std::string>& values) {
  std::string json = "[";
  for (const std::string& value : values) json += text_of(json.size() > 1 ? "," : "", value);
  return json + ']';
}

std::string json_texts(const std::vector<std::string>& texts) {
  std::vector<std::string> quoted;
  for (const std::string& text : texts) quoted.push_back(json_quoted(text));
  return json_list(quoted);
}

}  // namespace terrella
