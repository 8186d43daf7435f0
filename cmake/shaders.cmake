# What is made from shaders/, presets/ and src/scene/params.inc before C++ is compiled, all of it under
# <build>/generated:
#   shaders/scene_block.glsl   the uniform block of all parameters
#   shaders/<slot>/<stage>     each stage with its includes, checked
#   shader_sources.cpp         all stages, for gl; where planets of real size are not drawn, without those of nodes
#   shader_sources_real_size.cpp   with them
#   formulas/formulas.hpp      shaders/lib as C++, in float and in double
#   library_text.cpp           shaders/lib as text, for probe
#   preset_texts.cpp           all presets, for scene
#   font_bytes.cpp             the panel's font, which is a file of the system's

set(shaders ${PROJECT_SOURCE_DIR}/shaders)
set(generated ${PROJECT_BINARY_DIR}/generated)
set(glsl_folders "${shaders}\\;${generated}/shaders")
set(scripts ${PROJECT_SOURCE_DIR}/cmake)

set(params ${PROJECT_SOURCE_DIR}/src/scene/params.inc)
set(scene_block ${generated}/shaders/scene_block.glsl)
add_custom_command(OUTPUT ${scene_block}
  COMMAND ${CMAKE_COMMAND} -DPARAMS=${params} -DOUT=${scene_block} -P ${scripts}/scene_block.cmake
  DEPENDS ${params} ${scripts}/scene_block.cmake VERBATIM)

file(GLOB stages CONFIGURE_DEPENDS RELATIVE ${shaders} ${shaders}/*/*.vert ${shaders}/*/*.frag)
foreach(stage IN LISTS stages)
  set(out ${generated}/shaders/${stage})
  add_custom_command(OUTPUT ${out}
    COMMAND ${CMAKE_COMMAND} -DGLSL_FOLDERS=${glsl_folders} -DSTAGE=${stage} -DOUT=${out} -DGLSLANG=${GLSLANG}
            -P ${scripts}/shader_check.cmake
    DEPENDS ${shaders}/${stage} ${scene_block} DEPFILE ${out}.d VERBATIM)
endforeach()

# terrella_embed_shaders(out stage...): writes stages into a C++ file.
function(terrella_embed_shaders out)
  list(TRANSFORM ARGN PREPEND ${generated}/shaders/ OUTPUT_VARIABLE checked)
  list(JOIN ARGN "," stages)
  add_custom_command(OUTPUT ${out}
    COMMAND ${CMAKE_COMMAND} -DGLSL_FOLDERS=${glsl_folders} -DSTAGES=${stages} -DOUT=${out}
            -P ${scripts}/shader_embed.cmake
    DEPENDS ${checked} ${scripts}/shader_embed.cmake ${scripts}/glsl.cmake VERBATIM)
endfunction()

set(TERRELLA_REAL_SIZE_SHADER_SOURCES ${generated}/shader_sources_real_size.cpp)
terrella_embed_shaders(${TERRELLA_REAL_SIZE_SHADER_SOURCES} ${stages})
set(TERRELLA_SHADER_SOURCES ${TERRELLA_REAL_SIZE_SHADER_SOURCES})
if(NOT TERRELLA_REAL_SIZE)
  set(TERRELLA_SHADER_SOURCES ${generated}/shader_sources.cpp)
  list(FILTER stages EXCLUDE REGEX nodes)
  terrella_embed_shaders(${TERRELLA_SHADER_SOURCES} ${stages})
endif()

file(GLOB formulas CONFIGURE_DEPENDS ${shaders}/lib/*.glsl)
set(TERRELLA_FORMULAS ${generated}/formulas/formulas.hpp ${generated}/formulas/formulas.cpp)
add_custom_command(OUTPUT ${TERRELLA_FORMULAS}
  COMMAND ${CMAKE_COMMAND} -DGLSL_FOLDERS=${shaders} -DOUT=${generated}/formulas -P ${scripts}/formulas.cmake
  DEPENDS ${formulas} ${scripts}/formulas.cmake ${scripts}/glsl.cmake VERBATIM)

set(TERRELLA_LIBRARY_TEXT ${generated}/library_text.cpp)
add_custom_command(OUTPUT ${TERRELLA_LIBRARY_TEXT}
  COMMAND ${CMAKE_COMMAND} -DGLSL_FOLDERS=${shaders} -DOUT=${TERRELLA_LIBRARY_TEXT} -P ${scripts}/library_embed.cmake
  DEPENDS ${formulas} ${scripts}/library_embed.cmake ${scripts}/glsl.cmake VERBATIM)

set(presets ${PROJECT_SOURCE_DIR}/presets)
file(GLOB preset_files CONFIGURE_DEPENDS ${presets}/*.json ${presets}/*.txt)
set(TERRELLA_PRESET_TEXTS ${generated}/preset_texts.cpp)
add_custom_command(OUTPUT ${TERRELLA_PRESET_TEXTS}
  COMMAND ${CMAKE_COMMAND} -DFOLDER=${presets} -DOUT=${TERRELLA_PRESET_TEXTS} -P ${scripts}/preset_embed.cmake
  DEPENDS ${preset_files} ${scripts}/preset_embed.cmake VERBATIM)

set(TERRELLA_FONT_BYTES ${generated}/font_bytes.cpp)
add_custom_command(OUTPUT ${TERRELLA_FONT_BYTES}
  COMMAND ${CMAKE_COMMAND} -DHB_SUBSET=${HB_SUBSET} -DFONT=${PANEL_FONT} -DOUT=${TERRELLA_FONT_BYTES}
          -P ${scripts}/font_embed.cmake
  DEPENDS ${PANEL_FONT} ${scripts}/font_embed.cmake VERBATIM)
