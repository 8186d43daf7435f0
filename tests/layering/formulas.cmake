# cmake -DROOT=FOLDER -P formulas.cmake
# Holds that the shaders take every formula of height, colour and radiance from shaders/lib, which is also compiled as C++
# for the reference and the tests: what such formulas are made of stands nowhere else, but for the places listed here.

cmake_minimum_required(VERSION 3.25)

set(builtins exp exp2 log log2 pow sqrt inversesqrt sin cos tan asin acos atan tanh smoothstep step mix refract)

# Where to draw, how finely, and what becomes of a finished picture.
set(allowed
  "air/fresnel.vert mix sin cos"                                 # corners of a ring on the screen
  "clouds/bake.frag sqrt"                                        # how far apart texels are
  "clouds/shell_near.frag smoothstep exp2 pow"                   # which layers pixels add to the map's
  "fine_layers.glsl smoothstep"                                  # the same
  "anchored_layers.glsl sqrt"                                    # a place without the difference of large numbers
  "frame_block.glsl log2"                                        # depths
  "node_vertex.glsl sqrt"                                        # distances of vertices
  "node_surface.glsl sqrt"                                       # which layers pixels add to the vertices'
  "icosphere_near_ground.glsl sqrt"                              # how much of it a pixel covers
  "rings/plane.vert mix sin cos")                                # corners of an annulus

set(faults "")
set(unused "")
file(GLOB_RECURSE files RELATIVE ${ROOT}/shaders ${ROOT}/shaders/*.glsl ${ROOT}/shaders/*.vert ${ROOT}/shaders/*.frag)
list(FILTER files EXCLUDE REGEX "^lib/")
list(LENGTH files count)
if(count LESS 20)
  message(FATAL_ERROR "found only ${count} shaders in ${ROOT}/shaders")
endif()
foreach(file IN LISTS files)
  file(READ ${ROOT}/shaders/${file} text)
  string(REGEX REPLACE "//[^\n]*" "" text "${text}")
  set(may "")
  foreach(entry IN LISTS allowed)
    string(REPLACE " " ";" entry "${entry}")
    list(POP_FRONT entry name)
    if(name STREQUAL file)
      set(may ${entry})
    endif()
  endforeach()
  foreach(builtin IN LISTS builtins)
    if(text MATCHES "[^A-Za-z0-9_]${builtin}\\(")
      if(NOT builtin IN_LIST may)
        list(APPEND faults "shaders/${file}: ${builtin} belongs into a formula of shaders/lib")
      endif()
    elseif(builtin IN_LIST may)
      list(APPEND faults "shaders/${file}: ${builtin} is allowed, but not used")
    endif()
  endforeach()
endforeach()

if(faults)
  list(JOIN faults "\n  " faults)
  message(FATAL_ERROR "\n  ${faults}")
endif()
