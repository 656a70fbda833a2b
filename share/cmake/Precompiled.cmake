# Headers of others that nearly every file reads, compiled once for each way to compile: to read them
# is half of what a file costs. No file may rely on it: -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON builds without, so that
# an #include that is missing fails.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # ccache can tell what a precompiled header holds only by this.
  target_compile_options(limpet_options INTERFACE -fpch-preprocess)
endif()
# What runs once and briefly (a test, a report, a check before the dive) gains less from -O3 than -O3 costs the compiler:
# a third to a half of its time.
set(LIMPET_QUICK_OPTIONS "$<$<NOT:$<CONFIG:Debug>>:-O1>")

function(limpet_precompile target header)
  add_library(${target} OBJECT EXCLUDE_FROM_ALL "${CMAKE_SOURCE_DIR}/share/cmake/precompiled.cpp")
  target_link_libraries(${target} PRIVATE limpet_options thirdparty::eigen thirdparty::fmt ${ARGN})
  target_precompile_headers(${target} PRIVATE "$<$<COMPILE_LANGUAGE:CXX>:${CMAKE_SOURCE_DIR}/share/cmake/${header}>")
endfunction()

# A precompiled header holds for one level of optimisation.
limpet_precompile(limpet_precompiled precompiled.hpp)
limpet_precompile(limpet_precompiled_quick precompiled.hpp)
target_compile_options(limpet_precompiled_quick PRIVATE ${LIMPET_QUICK_OPTIONS})
if(BUILD_TESTING)
  limpet_precompile(limpet_precompiled_tests precompiled_tests.hpp GTest::gmock GTest::gtest)
  target_compile_options(limpet_precompiled_tests PRIVATE ${LIMPET_QUICK_OPTIONS})
endif()
