# cmake -DGLSL_FOLDERS=shaders -DOUT=FOLDER -P formulas.cmake
# Writes shaders/lib as the C++ header formulas.hpp, twice: terrella::f32 in float, terrella::f64 in double. A .cpp goes
# with it, so that a formula that is no C++ fails by itself.
#
# What the files keep to, to be read as both: functions and constants begin at the first column and nothing else does;
# literals of floats have a point, those of uints end in u; no swizzles of several components, no constructors of arrays
# or of own structs, no block comments, no shift by a signed number of a vector.

cmake_minimum_required(VERSION 3.25)

include(${CMAKE_CURRENT_LIST_DIR}/glsl.cmake)

glsl_library(files)

set(formulas "")
foreach(file IN LISTS files)
  file(READ ${GLSL_FOLDERS}/${file} text)
  set(text "\n${text}")  # so that a line's beginning can be told by the \n before it
  string(REGEX REPLACE "//[^\n]*" "" text "${text}")
  string(REGEX REPLACE "\n#include [^\n]*" "\n" text "${text}")
  string(REGEX REPLACE "([^A-Za-z0-9_.])([0-9]+\\.[0-9]*([eE][-+]?[0-9]+)?|\\.[0-9]+([eE][-+]?[0-9]+)?)"
                       "\\1Real(\\2)" text "${text}")
  # Twice, because a match takes in the character before: in `float(float(x))` the second would be missed.
  foreach(_ RANGE 1)
    string(REGEX REPLACE "([^A-Za-z0-9_])float([^A-Za-z0-9_])" "\\1Real\\2" text "${text}")
    string(REGEX REPLACE "([(, \n])(highp|mediump|lowp|in) +" "\\1" text "${text}")
  endforeach()
  string(REGEX REPLACE "([(, \n])(inout|out) +([A-Za-z0-9_]+) +([A-Za-z0-9_]+)(\\[[A-Za-z0-9_]+\\])"
                       "\\1\\3 (&\\4)\\5" text "${text}")
  string(REGEX REPLACE "([(, \n])(inout|out) +([A-Za-z0-9_]+) +" "\\1\\3& " text "${text}")
  string(REGEX REPLACE "\nconst " "\ninline const " text "${text}")
  # C++ may ask whether two structs are the same; on the line that is there, so that later ones keep their numbers.
  string(REGEX REPLACE "\nstruct ([A-Za-z0-9_]+) {" "\nstruct \\1 { bool operator==(const \\1&) const = default;" text "${text}")
  string(REGEX REPLACE "\n([A-Za-z0-9_]+ +[A-Za-z0-9_]+\\()" "\ninline \\1" text "${text}")
  string(SUBSTRING "${text}" 1 -1 text)
  string(APPEND formulas "#line 1 \"shaders/${file}\"\n${text}\n")
endforeach()

# The functions and types of GLSL that formulas may use; of textures there is one, a map of heights. Functions are named one
# by one, so that none is taken from <cmath> instead.
set(functions
  abs acos all any asin atan ceil clamp cos cosh cross degrees determinant distance dot equal exp exp2 faceforward floor
  fract greaterThan greaterThanEqual inverse inversesqrt isinf isnan length lessThan lessThanEqual log log2 max min mix
  mod normalize notEqual outerProduct pow radians reflect refract round sign sin sinh smoothstep sqrt step tan tanh
  transpose trunc)

function(write_namespace name real prefix)
  set(types "")
  foreach(type vec2 vec3 vec4 mat2 mat3 mat4)
    string(APPEND types "using ${type} = glm::${prefix}${type};\n")
  endforeach()
  foreach(type ivec2 ivec3 ivec4 uvec2 uvec3 uvec4 bvec2 bvec3 bvec4)
    string(APPEND types "using ${type} = glm::${type};\n")
  endforeach()
  foreach(function IN LISTS functions)
    string(APPEND types "using glm::${function};\n")
  endforeach()
  string(APPEND types "using sampler2D = HeightTexels;
")
  file(APPEND ${OUT}/formulas.hpp "
namespace terrella::${name} {
using Real = ${real};
using uint = unsigned int;
${types}
${formulas}
}  // namespace terrella::${name}
")
endfunction()

file(WRITE ${OUT}/formulas.hpp "// Made from shaders/lib by cmake/formulas.cmake.
#pragma once

#include <glm/glm.hpp>

#include \"base/height_map.hpp\"

// Where formulas may be told more than the driver can be (lib/heights.glsl).
#define TERRELLA_HOST
")
write_namespace(f32 float "")
file(APPEND ${OUT}/formulas.hpp "
// In double precision angles are exact (lib/angles.glsl).
#define TERRELLA_DOUBLE
")
write_namespace(f64 double "d")
file(APPEND ${OUT}/formulas.hpp "#undef TERRELLA_DOUBLE
#undef TERRELLA_HOST
")
file(WRITE ${OUT}/formulas.cpp "#include \"formulas/formulas.hpp\"\n")
