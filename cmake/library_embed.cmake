# cmake -DGLSL_FOLDERS=... -DOUT=library_text.cpp -P library_embed.cmake
# Writes all of shaders/lib as C++, each file after those that it includes: what the probe hands to the driver.

cmake_minimum_required(VERSION 3.25)

include(${CMAKE_CURRENT_LIST_DIR}/glsl.cmake)

file(GLOB lib RELATIVE ${GLSL_FOLDERS} ${GLSL_FOLDERS}/lib/*.glsl)
set(files "")
foreach(file IN LISTS lib)
  glsl_order(${file} files)
endforeach()

set(texts "")
set(number 0)
foreach(file IN LISTS files)
  glsl_read(${file} code)
  string(APPEND texts "    R\"glsl(#line 1 ${number} // ${file}\n${code})glsl\",\n")
  math(EXPR number "${number} + 1")
endforeach()

file(WRITE ${OUT} "// Made by cmake/library_embed.cmake.
#include \"probe/gpu.hpp\"

namespace terrella::probe {

std::string library_text() {
  static constexpr const char* pieces[] = {
${texts}};
  std::string text;
  for (const char* piece : pieces) text += piece;
  return text;
}

}  // namespace terrella::probe
")
