# Headers of others that nearly every file reads, compiled once for all libraries and once for all tests: to read them
# is half of what a file costs. No file may rely on it: -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON builds without, so that
# an #include that is missing fails.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # ccache can tell what a precompiled header holds only by this.
  target_compile_options(limpet_options INTERFACE -fpch-preprocess)
endif()
# A test runs once per build: what its own code gains from -O3 is less than what -O3 costs the compiler.
set(LIMPET_TEST_OPTIONS "$<$<NOT:$<CONFIG:Debug>>:-O1>")

function(limpet_precompile target header)
  add_library(${target} OBJECT EXCLUDE_FROM_ALL "${CMAKE_SOURCE_DIR}/share/cmake/precompiled.cpp")
  target_link_libraries(${target} PRIVATE limpet_options thirdparty::eigen thirdparty::fmt ${ARGN})
  target_precompile_headers(${target} PRIVATE "$<$<COMPILE_LANGUAGE:CXX>:${CMAKE_SOURCE_DIR}/share/cmake/${header}>")
endfunction()

limpet_precompile(limpet_precompiled precompiled.hpp)
if(BUILD_TESTING)
  limpet_precompile(limpet_precompiled_tests precompiled_tests.hpp GTest::gmock GTest::gtest)
  target_compile_options(limpet_precompiled_tests PRIVATE ${LIMPET_TEST_OPTIONS})
endif()
