# The target `imgui`: Dear ImGui with its OpenGL 3 backend, compiled from source for desktop and browser.

set(version 1.90.1)
set(IMGUI_DIR ${PROJECT_SOURCE_DIR}/build/deps/imgui-${version} CACHE PATH "Sources of Dear ImGui, 1.90.1 or newer")

if(NOT EXISTS ${IMGUI_DIR}/imgui.cpp)
  find_program(APT_GET apt-get NO_CMAKE_FIND_ROOT_PATH)
  if(APT_GET)
    message(STATUS "Dear ImGui ${version}: asking apt for its source package")
    execute_process(COMMAND ${PROJECT_SOURCE_DIR}/scripts/fetch_imgui.sh ${IMGUI_DIR})
  endif()
endif()
if(NOT EXISTS ${IMGUI_DIR}/imgui.cpp)
  message(STATUS "Dear ImGui ${version}: fetching it from its own repository")
  include(FetchContent)
  FetchContent_Declare(imgui GIT_REPOSITORY https://github.com/ocornut/imgui.git GIT_TAG v${version} GIT_SHALLOW ON
                       SOURCE_DIR ${IMGUI_DIR})
  FetchContent_MakeAvailable(imgui)
endif()

# The panel has a font of its own: Dear ImGui's, of text that hardly compresses, would be a thirtieth of the page's download.
file(READ ${IMGUI_DIR}/imgui_draw.cpp drawing)
set(font "static const char proggy_clean_ttf_compressed_data_base85")
string(FIND "${drawing}" "${font}" from)
string(FIND "${drawing}" "static const char* GetDefaultCompressedFontDataTTFBase85()" to REVERSE)
if(from GREATER 0 AND to GREATER from)
  string(SUBSTRING "${drawing}" 0 ${from} before)
  string(SUBSTRING "${drawing}" ${to} -1 after)
  set(drawing "${before}${font}[] = \"\";\n${after}")
endif()
set(imgui_draw ${PROJECT_BINARY_DIR}/generated/imgui_draw.cpp)
file(CONFIGURE OUTPUT ${imgui_draw} CONTENT "@drawing@" @ONLY)

add_library(imgui STATIC
  ${IMGUI_DIR}/imgui.cpp ${imgui_draw} ${IMGUI_DIR}/imgui_tables.cpp ${IMGUI_DIR}/imgui_widgets.cpp
  ${IMGUI_DIR}/backends/imgui_impl_opengl3.cpp)
target_include_directories(imgui SYSTEM PUBLIC ${IMGUI_DIR} ${IMGUI_DIR}/backends)
# Its demo and its debugging windows would be a third of the page's download.
target_compile_definitions(imgui PUBLIC IMGUI_DISABLE_DEMO_WINDOWS IMGUI_DISABLE_DEBUG_TOOLS
                           IMGUI_DISABLE_OBSOLETE_FUNCTIONS)
if(EMSCRIPTEN)
  # The page has no files; and its context is WebGL 2, where the backend by itself would assume WebGL 1.
  target_compile_definitions(imgui PUBLIC IMGUI_DISABLE_FILE_FUNCTIONS PRIVATE IMGUI_IMPL_OPENGL_ES3)
else()
  target_link_libraries(imgui PRIVATE ${CMAKE_DL_LIBS})
endif()
target_compile_options(imgui PRIVATE -fno-sanitize=all)  # not ours to check, and slow to compile
