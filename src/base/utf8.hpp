#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace terrella {

// How many bytes the first character of the text takes, 1 to 4; 0 if no UTF-8 character starts there (or the text is
// empty). Overlong forms, surrogates and what lies beyond U+10FFFF are not characters.
std::size_t utf8_length(std::string_view text);

// The place of the first byte that is not UTF-8, or npos.
std::size_t find_not_utf8(std::string_view text);

// The text with U+FFFD for each byte that is not UTF-8.
std::string repaired_utf8(std::string_view text);

// Appends the character of a code point; U+FFFD for a surrogate or a number too large.
void append_utf8(std::string& text, std::uint32_t code_point);

}  // namespace terrella
