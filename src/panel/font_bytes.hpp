// The panel's font, made from a package of the system by cmake/font_embed.cmake.
#pragma once

#include <span>

namespace terrella {

// A TrueType file.
std::span<const unsigned char> font_bytes();

}  // namespace terrella
