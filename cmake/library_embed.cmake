# cmake -DGLSL_FOLDERS=... -DOUT=library_text.cpp -P library_embed.cmake
# Writes all of shaders/lib as C++, each file after those that it includes: what the probe hands to the driver.

cmake_minimum_required(VERSION 3.25)

include(${CMAKE_CURRENT_LIST_DIR}/glsl.cmake)

glsl_library(files)

glsl_literals("${files}" texts)

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
