# Where -O3 would not be noticed (share/cmake/Precompiled.cmake says why).
function(limpet_compile_quickly target)
  target_compile_options(${target} PRIVATE ${LIMPET_QUICK_OPTIONS})
  target_precompile_headers(${target} REUSE_FROM limpet_precompiled_quick)
endfunction()

# limpet_library(<name> [QUICK] [DEPENDS lib...] [PRIVATE thirdparty::x...])
#   target limpet::<name> of every *.cpp in the current folder; its public edges are other Limpet libraries.
#   QUICK: compiled quickly, for what is done once, beside what takes its time, and never on board.
function(limpet_library name)
  cmake_parse_arguments(ARG "QUICK" "" "DEPENDS;PRIVATE" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS "*.cpp")
  list(FILTER sources EXCLUDE REGEX "/main.cpp$")
  if(sources)
    add_library(limpet_${name} STATIC ${sources})
    set(scope PUBLIC)
    target_link_libraries(limpet_${name} PRIVATE ${ARG_PRIVATE})
    if(ARG_QUICK)
      limpet_compile_quickly(limpet_${name})
    else()
      target_precompile_headers(limpet_${name} REUSE_FROM limpet_precompiled)
    endif()
  else()
    add_library(limpet_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  list(TRANSFORM ARG_DEPENDS PREPEND limpet::)
  target_link_libraries(limpet_${name} ${scope} $<BUILD_INTERFACE:limpet_options> thirdparty::eigen thirdparty::fmt
                                                ${ARG_DEPENDS})
  target_compile_features(limpet_${name} ${scope} cxx_std_20)
  set_target_properties(limpet_${name} PROPERTIES EXPORT_NAME ${name})
  add_library(limpet::${name} ALIAS limpet_${name})
endfunction()

# limpet_app(<process> DEPENDS lib... [PRIVATE thirdparty::x...] [HOSTS lib...])
#   the app class of apps/<process> and its program; `limpet` hosts every one of them, found by its registered name.
#   HOSTS: what registers itself by name for this app, as behaviors do.
function(limpet_app name)
  cmake_parse_arguments(ARG "" "" "DEPENDS;PRIVATE;HOSTS" ${ARGN})
  limpet_library(${name} DEPENDS ${ARG_DEPENDS} PRIVATE ${ARG_PRIVATE})
  set_property(GLOBAL APPEND PROPERTY LIMPET_APPS limpet::${name})
  limpet_process(${name} ${name} ${ARG_HOSTS})
endfunction()

# limpet_process(<process> lib...): the program of the current folder's main.cpp; what registers itself in lib is kept.
function(limpet_process name)
  add_executable(${name} main.cpp)
  set_property(GLOBAL APPEND PROPERTY LIMPET_PROCESSES ${name})
  list(TRANSFORM ARGN PREPEND limpet::)
  string(JOIN "," libraries ${ARGN})
  target_link_libraries(${name} PRIVATE limpet_options limpet::app thirdparty::fmt thirdparty::eigen
                                        "$<LINK_LIBRARY:WHOLE_ARCHIVE,${libraries}>")
endfunction()

# limpet_test(<name> FOLDER <dir> DEPENDS lib... [PRIVATE thirdparty::x...] [TIMEOUT s] [SINGLY])
#   one GoogleTest program of every *.cpp in <dir>. CTest runs a suite of it at a time, for to start a program that loads
#   OpenCV and MRPT takes longer than most tests; SINGLY: a test at a time and before all others, for what takes long.
function(limpet_test name)
  cmake_parse_arguments(ARG "SINGLY" "FOLDER;TIMEOUT" "DEPENDS;PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${ARG_FOLDER}/*.cpp")
  if(NOT sources)
    return()
  endif()
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 120)
  endif()
  math(EXPR ARG_TIMEOUT "${ARG_TIMEOUT} * ${LIMPET_TEST_TIMEOUT_SCALE}")
  add_executable(${name} ${sources})
  list(TRANSFORM ARG_DEPENDS PREPEND limpet::)
  target_link_libraries(${name} PRIVATE limpet_options ${ARG_DEPENDS} ${ARG_PRIVATE} GTest::gmock GTest::gtest_main
                                        thirdparty::fmt thirdparty::eigen)
  target_compile_options(${name} PRIVATE ${LIMPET_QUICK_OPTIONS})
  target_precompile_headers(${name} REUSE_FROM limpet_precompiled_tests)
  target_compile_definitions(${name} PRIVATE LIMPET_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
  limpet_discover_tests(${name} ${ARG_TIMEOUT} ${ARG_SINGLY})
endfunction()

# Tells CTest, once the program is built, of its suites or of its tests.
function(limpet_discover_tests name timeout singly)
  set(found "${CMAKE_CURRENT_BINARY_DIR}/${name}_tests.cmake")
  add_custom_command(
    TARGET ${name}
    POST_BUILD
    BYPRODUCTS "${found}"
    COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:${name}>" "-DNAME=${name}" "-DTIMEOUT=${timeout}" "-DSINGLY=${singly}"
            "-DFOUND=${found}" "-DFOLDER=${CMAKE_CURRENT_BINARY_DIR}" -P "${CMAKE_SOURCE_DIR}/share/cmake/DiscoverTests.cmake"
    VERBATIM)
  set(include_file "${CMAKE_CURRENT_BINARY_DIR}/${name}_include.cmake")
  file(WRITE "${include_file}" "if(EXISTS \"${found}\")\n  include(\"${found}\")\n"
                               "else()\n  add_test(${name}_NOT_BUILT ${name}_NOT_BUILT)\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${include_file}")
endfunction()
