# cmake -DFOLDER=presets -DOUT=preset_texts.cpp -P preset_embed.cmake
# Writes the presets as C++: first those named in order.txt, a name a line, then the others by name.

cmake_minimum_required(VERSION 3.25)

file(GLOB names RELATIVE ${FOLDER} ${FOLDER}/*.json)
list(TRANSFORM names REPLACE "\\.json$" "")
list(SORT names)
if(EXISTS ${FOLDER}/order.txt)
  file(STRINGS ${FOLDER}/order.txt order)
  foreach(name IN LISTS order)
    if(NOT name IN_LIST names)
      message(FATAL_ERROR "${FOLDER}/order.txt: there is no preset ${name}")
    endif()
  endforeach()
  list(PREPEND names ${order})
  list(REMOVE_DUPLICATES names)
endif()

set(texts "")
foreach(name IN LISTS names)
  file(READ ${FOLDER}/${name}.json json)
  # The page carries no indents, nor spaces between members.
  string(REGEX REPLACE "\n *" "" json "${json}")
  string(REPLACE "\": " "\":" json "${json}")
  string(REPLACE ", \"" ",\"" json "${json}")
  string(APPEND texts "    PresetText{\"${name}\", R\"json(${json})json\"},\n")
endforeach()
list(LENGTH names count)

file(WRITE ${OUT} "// Made by cmake/preset_embed.cmake.
#include \"scene/preset_texts.hpp\"

#include <array>

namespace terrella {

std::span<const PresetText> preset_texts() {
  static constexpr std::array<PresetText, ${count}> texts = {
${texts}  };
  return texts;
}

}  // namespace terrella
")
