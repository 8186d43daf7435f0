# The packages of the system that everything builds upon. Each becomes a target whose headers count as SYSTEM.

# Header-only packages serve the browser as well, but em++ must not see the whole include folder of the system: it gets
# a folder with a link to just this package.
function(terrella_header_package name header)
  find_path(${name}_INCLUDE_DIR ${header} NO_CMAKE_FIND_ROOT_PATH
            PATHS /usr/include /usr/local/include /opt/homebrew/include REQUIRED)
  cmake_path(GET header PARENT_PATH folder)
  set(links ${PROJECT_BINARY_DIR}/include)
  file(MAKE_DIRECTORY ${links})
  file(CREATE_LINK ${${name}_INCLUDE_DIR}/${folder} ${links}/${folder} SYMBOLIC)
  add_library(${name} INTERFACE)
  target_include_directories(${name} SYSTEM INTERFACE ${links})
endfunction()

terrella_header_package(glm glm/glm.hpp)
terrella_header_package(json nlohmann/json.hpp)

find_program(GLSLANG NAMES glslangValidator glslang NO_CMAKE_FIND_ROOT_PATH REQUIRED)

# The panel's font, and what cuts it down.
find_program(HB_SUBSET hb-subset NO_CMAKE_FIND_ROOT_PATH REQUIRED)
find_file(PANEL_FONT Roboto-Regular.ttf NO_CMAKE_FIND_ROOT_PATH
          PATHS /usr/share/fonts /usr/local/share/fonts PATH_SUFFIXES truetype/roboto/unhinted/RobotoTTF REQUIRED)

if(EMSCRIPTEN)
  find_program(ESBUILD esbuild NO_CMAKE_FIND_ROOT_PATH REQUIRED)  # makes scripts small
else()
  find_package(Threads REQUIRED)
  find_package(PNG REQUIRED)
  find_package(CLI11 REQUIRED)
  find_package(glfw3 3.3 REQUIRED)
  find_package(GTest REQUIRED)
  find_package(benchmark QUIET)  # only `make bench` needs it
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET epoxy)
  pkg_check_modules(egl REQUIRED IMPORTED_TARGET egl)
endif()
