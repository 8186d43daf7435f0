# Finds the toolchain file that every Emscripten brings, wherever that Emscripten is installed.

find_program(EM_CONFIG em-config HINTS $ENV{EMSDK}/upstream/emscripten NO_CMAKE_FIND_ROOT_PATH)
if(NOT EM_CONFIG)
  message(FATAL_ERROR "Emscripten is not installed: run scripts/setup.sh web, or put its em-config on the PATH")
endif()
execute_process(COMMAND ${EM_CONFIG} EMSCRIPTEN_ROOT OUTPUT_VARIABLE EMSCRIPTEN_ROOT
                OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
include(${EMSCRIPTEN_ROOT}/cmake/Modules/Platform/Emscripten.cmake)

# Debian's Emscripten optimizes its JavaScript with Debian's acorn, which only Debian's own node would find by itself.
set(TERRELLA_LINK_LAUNCHER "")
if(EXISTS /usr/share/nodejs/acorn)
  set(TERRELLA_LINK_LAUNCHER "${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs")
endif()
