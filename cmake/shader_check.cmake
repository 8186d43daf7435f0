# cmake -DGLSL_FOLDERS=... -DSTAGE=ground/icosphere.frag -DOUT=... -DGLSLANG=... -P shader_check.cmake
# Puts a stage and all that it includes into one text, checks it in both dialects, and writes OUT (with OUT.d, what it
# was made from). Errors name the file and line that they were written in.

cmake_minimum_required(VERSION 3.25)

include(${CMAKE_CURRENT_LIST_DIR}/glsl.cmake)

set(files "")
glsl_order(${STAGE} files)
set(text "")
set(number 0)
foreach(file IN LISTS files)
  glsl_read(${file} code)
  string(APPEND text "#line 1 ${number}\n${code}\n")
  math(EXPR number "${number} + 1")
endforeach()

cmake_path(GET STAGE EXTENSION LAST_ONLY extension)
set(head_core "#version 330 core\n")
set(head_es "#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp samplerCube;
")
foreach(dialect core es)
  set(flat ${OUT}.${dialect}${extension})
  file(WRITE ${flat} "${head_${dialect}}${text}")
  execute_process(COMMAND ${GLSLANG} ${flat} RESULT_VARIABLE failed OUTPUT_VARIABLE report ERROR_VARIABLE report)
  if(failed)
    set(number 0)
    foreach(file IN LISTS files)
      glsl_find(${file} path)
      string(REPLACE "ERROR: ${number}:" "${path}:" report "${report}")
      math(EXPR number "${number} + 1")
    endforeach()
    message("${report}")
    message(FATAL_ERROR "${STAGE} is not valid GLSL (${dialect})")
  endif()
endforeach()

file(WRITE ${OUT} "${text}")
set(paths ${CMAKE_CURRENT_LIST_FILE} ${CMAKE_CURRENT_LIST_DIR}/glsl.cmake)
foreach(file IN LISTS files)
  glsl_find(${file} path)
  list(APPEND paths ${path})
endforeach()
list(JOIN paths " " paths)
file(WRITE ${OUT}.d "${OUT}: ${paths}\n")
