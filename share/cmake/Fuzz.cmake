# limpet_fuzz(<name> DEPENDS lib...): the libFuzzer program fuzz_<name> of <name>_fuzz.cpp, and a test that it survives
# LIMPET_FUZZ_SECONDS from the seeds: every file under missions, plugs and the target's own corpus/<name>, and what
# earlier runs in the same build folder found.
set(LIMPET_FUZZ_SECONDS 20 CACHE STRING "How long the test of each fuzz target searches")
if(LIMPET_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "LIMPET_FUZZ needs Clang: cmake --preset fuzz")
  endif()
  target_compile_options(limpet_options INTERFACE -fsanitize=fuzzer-no-link)
  add_custom_target(fuzz_targets)
endif()

function(limpet_fuzz name)
  cmake_parse_arguments(ARG "" "" "DEPENDS" ${ARGN})
  add_executable(fuzz_${name} "${name}_fuzz.cpp")
  list(TRANSFORM ARG_DEPENDS PREPEND limpet::)
  target_link_libraries(fuzz_${name} PRIVATE limpet_options ${ARG_DEPENDS} thirdparty::fmt thirdparty::eigen)
  target_link_options(fuzz_${name} PRIVATE -fsanitize=fuzzer)
  add_dependencies(fuzz_targets fuzz_${name})
  set(corpus "${CMAKE_CURRENT_BINARY_DIR}/corpus/${name}")
  file(MAKE_DIRECTORY "${corpus}")
  set(seeds "${CMAKE_SOURCE_DIR}/missions" "${CMAKE_SOURCE_DIR}/plugs")
  if(IS_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/corpus/${name}")
    list(APPEND seeds "${CMAKE_CURRENT_SOURCE_DIR}/corpus/${name}")
  endif()
  add_test(NAME fuzz_${name} COMMAND fuzz_${name} -max_total_time=${LIMPET_FUZZ_SECONDS} -timeout=10 -print_final_stats=1
                                             "-artifact_prefix=${corpus}/../${name}-" "${corpus}" ${seeds})
endfunction()
