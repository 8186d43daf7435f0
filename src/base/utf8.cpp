#include "base/utf8.hpp"

#include <algorithm>

namespace terrella {
namespace {

constexpr std::uint32_t kReplacement = 0xfffd;

bool is_surrogate(std::uint32_t code) { return code >= 0xd800 && code <= 0xdfff; }

// The lead byte's promise: how many bytes follow it, which of its bits count, and the least code point that needs them.
struct Lead {
  std::size_t length;
  std::uint32_t bits;
  std::uint32_t least;
};

Lead lead_of(unsigned char byte) {
  if (byte < 0x80) return {1, byte, 0};
  if ((byte & 0xe0u) == 0xc0) return {2, byte & 0x1fu, 0x80};
  if ((byte & 0xf0u) == 0xe0) return {3, byte & 0x0fu, 0x800};
  if ((byte & 0xf8u) == 0xf0) return {4, byte & 0x07u, 0x10000};
  return {0, 0, 0};
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
  if (text.empty()) return 0;
  const Lead lead = lead_of(static_cast<unsigned char>(text[0]));
  if (lead.length == 0 || lead.length > text.size()) return 0;
  std::uint32_t code = lead.bits;
  for (std::size_t i = 1; i < lead.length; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte & 0xc0u) != 0x80) return 0;
    code = code << 6 | (byte & 0x3fu);
  }
  const bool valid = code >= lead.least && code <= 0x10ffff && !is_surrogate(code);
  return valid ? lead.length : 0;
}

std::size_t find_not_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(text.substr(at));
    if (length == 0) return at;
    at += length;
  }
  return std::string_view::npos;
}

std::string repaired_utf8(std::string_view text) {
  std::string repaired;
  while (!text.empty()) {
    const std::size_t bad = std::min(find_not_utf8(text), text.size());
    repaired += text.substr(0, bad);
    text.remove_prefix(bad);
    if (text.empty()) break;
    append_utf8(repaired, kReplacement);
    text.remove_prefix(1);
  }
  return repaired;
}

void append_utf8(std::string& text, std::uint32_t code) {
  if (is_surrogate(code) || code > 0x10ffff) code = kReplacement;
  const auto tail = [code](int shift) { return static_cast<char>(0x80u | (code >> shift & 0x3fu)); };
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xc0u | code >> 6);
    text += tail(0);
  } else if (code < 0x10000) {
    text += static_cast<char>(0xe0u | code >> 12);
    text += tail(6);
    text += tail(0);
  } else {
    text += static_cast<char>(0xf0u | code >> 18);
    text += tail(12);
    text += tail(6);
    text += tail(0);
  }
}

}  // namespace terrella
