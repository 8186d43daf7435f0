#include "scene/link.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "base/check.hpp"
#include "base/text.hpp"
#include "base/utf8.hpp"
#include "scene/entries.hpp"
#include "scene/parameters.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

constexpr std::array<std::string_view, 2> kPageKeys = {"panel", "pause"};

// What a query gives a meaning of its own, as percent signs and digits.
std::string percent_encoded(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789ABCDEF", kPlain = "-_.";
  std::string encoded;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const char lower = static_cast<char>(byte | 0x20U);
    const bool plain =
        (lower >= 'a' && lower <= 'z') || (c >= '0' && c <= '9') || kPlain.find(c) != std::string_view::npos;
    if (plain) {
      encoded += c;
    } else {
      encoded += {'%', kDigits[byte >> 4U], kDigits[byte & 15U]};
    }
  }
  return encoded;
}

// A colour without its '#', which would end a query.
std::string link_value(const Value& value) {
  if (const auto* name = std::get_if<std::string>(&value)) return percent_encoded(*name);
  const std::string text = to_text(value);
  return text.starts_with('#') ? text.substr(1) : text;
}

// A bare query may hold a '#', as colours do; in a whole link that is where the query ends.
std::string_view query_of(std::string_view link) {
  const std::size_t question = link.find('?');
  if (question != std::string_view::npos) {
    link.remove_prefix(question + 1);
    return link.substr(0, link.find('#'));
  }
  return link.find("://") == std::string_view::npos ? link : std::string_view();
}

// The percent-encoded text as it was; nothing if a percent sign has no two digits, or the outcome is not UTF-8.
std::optional<std::string> percent_decoded(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789abcdef0123456789ABCDEF";
  std::string decoded;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] != '%') {
      decoded += text[at] == '+' ? ' ' : text[at];
      continue;
    }
    if (at + 2 >= text.size()) return std::nullopt;
    const std::size_t high = kDigits.find(text[at + 1]), low = kDigits.find(text[at + 2]);
    if (high == std::string_view::npos || low == std::string_view::npos) return std::nullopt;
    decoded += static_cast<char>((high % 16) << 4 | low % 16);
    at += 2;
  }
  if (find_not_utf8(decoded) != std::string_view::npos) return std::nullopt;
  return decoded;
}

std::vector<Entry> read_query(std::string_view query, Issues& issues) {
  std::vector<Entry> entries;
  while (!query.empty()) {
    const std::string_view pair = query.substr(0, query.find('&'));
    query.remove_prefix(std::min(pair.size() + 1, query.size()));
    if (pair.empty()) continue;
    const std::size_t equals = std::min(pair.find('='), pair.size());
    const auto key = percent_decoded(pair.substr(0, equals));
    const auto text = percent_decoded(pair.substr(std::min(equals + 1, pair.size())));
    if (key && text) {
      entries.push_back({*key, *text, std::nullopt});
    } else {
      issues.add("", text_of('"', shortened(pair), "\" is not percent-encoded UTF-8 text."));
    }
  }
  return entries;
}

}  // namespace

std::string to_link(const SceneDocument& document) {
  const Preset* preset = find_preset(document.preset);
  CHECK(preset != nullptr, document.preset);
  std::string link;
  const auto add = [&](std::string_view key, std::string_view text) {
    link += text_of(link.empty() ? "" : "&", key, '=', text);
  };
  if (document.preset != kDefaultPreset) add("preset", document.preset);
  for (const Parameter& parameter : parameters()) {
    const Value value = parameter.get(document.scene);
    if (value != parameter.get(preset->scene)) add(parameter.path, link_value(value));
  }
  return link;
}

Issues load_link(SceneDocument& document, std::string_view link) {
  Issues issues;
  if (link.size() > kLongestLink) {
    issues.add("", text_of("The link is ", link.size(), " bytes long; at most ", kLongestLink, " are read."));
    return issues;
  }
  const std::vector<Entry> entries = read_query(query_of(link), issues);
  apply_entries(document, entries, kPageKeys, issues);
  return issues;
}

}  // namespace terrella
