# What the scripts that read GLSL have in common: `#include "lib/noise.glsl"` lines, which stand before all else in a
# file and count once, however often and deeply they come.

# glsl_order(file out): appends to the list `out` what the file includes, then the file itself, each only once. Paths
# are relative to the shaders' folder or to that of generated files, GLSL_FOLDERS.
function(glsl_order file out)
  if(file IN_LIST ${out})
    return()
  endif()
  glsl_find(${file} path)
  file(STRINGS ${path} includes REGEX "^#include")
  foreach(include IN LISTS includes)
    if(NOT include MATCHES "^#include \"([^\"]+)\"$")
      message(FATAL_ERROR "${path}: cannot read ${include}")
    endif()
    glsl_order(${CMAKE_MATCH_1} ${out})
  endforeach()
  set(${out} ${${out}} ${file} PARENT_SCOPE)
endfunction()

function(glsl_find file out)
  find_file(found ${file} PATHS ${GLSL_FOLDERS} NO_DEFAULT_PATH NO_CACHE)
  if(NOT found)
    message(FATAL_ERROR "${file}: included, but not there")
  endif()
  set(${out} ${found} PARENT_SCOPE)
endfunction()

# glsl_read(file out): the text without comments, includes and indentation, which would be a third of the page's
# download. Line numbers stay as they are.
function(glsl_read file out)
  glsl_find(${file} path)
  file(READ ${path} text)
  string(REGEX REPLACE "//[^\n]*" "" text "\n${text}")
  string(REGEX REPLACE "[ \t]+\n" "\n" text "${text}")
  string(REGEX REPLACE "\n[ \t]+" "\n" text "${text}")
  string(REGEX REPLACE "^(\n*#include [^\n]*)+" "" code "${text}")
  if(code MATCHES "\n#include [^\n]*")
    message(FATAL_ERROR "${path}: this stands after other code:${CMAKE_MATCH_0}")
  elseif(code MATCHES "/\\*")
    message(FATAL_ERROR "${path}: comments are written with //")
  endif()
  string(REGEX REPLACE "\n#include [^\n]*" "\n" text "${text}")
  string(SUBSTRING "${text}" 1 -1 text)
  set(${out} "${text}" PARENT_SCOPE)
endfunction()

# glsl_library(out): all files of lib, each after those that it includes.
function(glsl_library out)
  file(GLOB lib RELATIVE ${GLSL_FOLDERS} ${GLSL_FOLDERS}/lib/*.glsl)
  set(ordered "")
  foreach(file IN LISTS lib)
    glsl_order(${file} ordered)
  endforeach()
  set(${out} ${ordered} PARENT_SCOPE)
endfunction()

# glsl_literals(files out): their texts as literals of C++ with a comma behind each. The #line makes a driver's message
# name the file, by its place in the list, and its line.
function(glsl_literals files out)
  set(texts "")
  set(number 0)
  foreach(file IN LISTS files)
    glsl_read(${file} code)
    if(code MATCHES "#define")
      message(FATAL_ERROR "${file}: without spaces, a #define would become another")
    endif()
    string(REGEX REPLACE " ?([=*/<>(){},;?:&|%]) ?" "\\1" code "${code}")  # 1.1 kB of the page's download
    # Nor around a sign, but where that parts it from another: a - -b
    string(REGEX REPLACE "([^-+]) ([-+])" "\\1\\2" code "${code}")
    string(REGEX REPLACE "([-+]) ([^-+])" "\\1\\2" code "${code}")
    string(APPEND texts "    R\"glsl(#line 1 ${number} // ${file}\n${code})glsl\",\n")
    math(EXPR number "${number} + 1")
  endforeach()
  set(${out} "${texts}" PARENT_SCOPE)
endfunction()
