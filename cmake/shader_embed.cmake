# cmake -DGLSL_FOLDERS=... -DSTAGES=ground/icosphere.vert,... -DOUT=shader_sources.cpp -P shader_embed.cmake
# Writes all stages as C++. A file that many stages include is there once: a stage is a list of files.

cmake_minimum_required(VERSION 3.25)

include(${CMAKE_CURRENT_LIST_DIR}/glsl.cmake)

string(REPLACE "," ";" STAGES "${STAGES}")
set(pieces "")
set(stages "")
foreach(stage IN LISTS STAGES)
  set(files "")
  glsl_order(${stage} files)
  set(numbers "")
  foreach(file IN LISTS files)
    glsl_order(${file} pieces)
    list(FIND pieces ${file} number)
    list(APPEND numbers ${number})
  endforeach()
  list(JOIN numbers ", " numbers)
  string(APPEND stages "    {\"${stage}\", {${numbers}}},\n")
endforeach()

glsl_literals("${pieces}" texts)

file(WRITE ${OUT} "// Made by cmake/shader_embed.cmake.
#include \"gl/shader_sources.hpp\"

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

namespace terrella::gl {
namespace {

const std::vector<std::string_view> pieces = {
${texts}};

const std::map<std::string_view, std::vector<std::size_t>> stages = {
${stages}};

}  // namespace

std::string_view shader_source(std::string_view path) {
  static std::map<std::string_view, std::string> joined;
  const auto stage = stages.find(path);
  if (stage == stages.end()) {
    std::fprintf(stderr, \"There is no shader %.*s.\\n\", static_cast<int>(path.size()), path.data());
    std::abort();
  }
  const auto [text, is_new] = joined.try_emplace(stage->first);
  if (is_new) {
    for (const std::size_t piece : stage->second) text->second += pieces[piece];
  }
  return text->second;
}

}  // namespace terrella::gl
")
