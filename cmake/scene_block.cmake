# cmake -DPARAMS=params.inc -DOUT=scene_block.glsl -P scene_block.cmake
# The uniform block of all parameters, a member <group>_<name> each. Vectors come first, then floats, then ints, each in
# the order of params.inc: so std140 leaves no gaps, and the C++ side can mirror it line by line.

cmake_minimum_required(VERSION 3.25)

file(READ ${PARAMS} text)
string(REPLACE ";" "," text "${text}")  # a semicolon would split a line in two
string(REGEX MATCHALL "\n(FLOAT|LENGTH|INT|BOOL|COLOR|CHOICE) *\\([^,]+,[^,]+," lines "${text}")

foreach(line IN LISTS lines)
  string(REGEX REPLACE "\n([A-Z]+) *\\( *([a-z0-9_]+), *([a-z0-9_]+)," "\\1;\\2;\\3" line "${line}")
  list(GET line 0 type)
  list(GET line 1 group)
  list(GET line 2 name)
  # What no shader asks for: where the camera stands, how the clock runs, how well to draw.
  if(group MATCHES "^(camera|time|quality)$")
    continue()
  elseif(type STREQUAL COLOR)
    string(APPEND vectors "  vec4 ${group}_${name};\n")
  elseif(type MATCHES "^(FLOAT|LENGTH)$")
    string(APPEND floats "  float ${group}_${name};\n")
  else()
    string(APPEND ints "  int ${group}_${name};\n")
  endif()
endforeach()

file(WRITE ${OUT} "layout(std140) uniform SceneBlock {\n${vectors}${floats}${ints}};\n")
