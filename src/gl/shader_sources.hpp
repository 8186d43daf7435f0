#pragma once

#include <string_view>

namespace terrella::gl {

// A shader stage as it goes to the compiler, all that it includes in it, but without its #version line. path is
// relative to shaders/, as in "ground/icosphere.frag"; one that is not there stops the program. The text lives as long
// as the program does. Defined by cmake/shader_embed.cmake.
std::string_view shader_source(std::string_view path);

}  // namespace terrella::gl
