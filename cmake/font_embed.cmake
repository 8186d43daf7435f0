# cmake -DHB_SUBSET=... -DFONT=Roboto-Regular.ttf -DOUT=font_bytes.cpp -P font_embed.cmake
# Writes the panel's font as C++: a twentieth of its file, just the letters of western Europe and what our own sentences have
# besides, as outlines without hints or rules of layout, of which Dear ImGui reads none.

cmake_minimum_required(VERSION 3.25)

set(letters 20-7E,A0-FF,2026)
set(unread GSUB,GPOS,GDEF,OS/2,name,post)

execute_process(COMMAND ${HB_SUBSET} ${FONT} --unicodes=${letters} --no-hinting --layout-features=
                        --drop-tables+=${unread} --output-file=${OUT}.ttf COMMAND_ERROR_IS_FATAL ANY)
file(READ ${OUT}.ttf bytes HEX)
string(LENGTH "${bytes}" count)
math(EXPR count "${count} / 2")
string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")

file(WRITE ${OUT} "// Made by cmake/font_embed.cmake.
#include \"panel/font_bytes.hpp\"

#include <array>

namespace terrella {

std::span<const unsigned char> font_bytes() {
  static constexpr std::array<unsigned char, ${count}> bytes = {${bytes}};
  return bytes;
}

}  // namespace terrella
")
