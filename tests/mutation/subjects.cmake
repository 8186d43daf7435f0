# Read by the copy in which run.sh plants mistakes. Each changes the one header that all laws include, so that all would have
# to be compiled for it. Most are noticed by the laws of the file that they are in: each laws/<subject>_test.cpp is a program
# of its own, <subject>_test, too. For the program of all laws what they include is compiled once.

function(add_subjects)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/laws/*_test.cpp)
  foreach(source IN LISTS sources)
    get_filename_component(name ${source} NAME_WE)
    add_executable(${name} EXCLUDE_FROM_ALL ${source})
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
    file(STRINGS ${source} probing REGEX "#include \"probe/")
    set(library terrella_formulas)
    if(probing)
      set(library terrella_probe)
    endif()
    target_link_libraries(${name} PRIVATE ${library} GTest::gtest_main)
  endforeach()
  target_precompile_headers(laws_tests PRIVATE <gtest/gtest.h> <random> <formulas/formulas.hpp>)
endfunction()
cmake_language(DEFER CALL add_subjects)
