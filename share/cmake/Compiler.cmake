# Warnings and sanitizers of every Limpet target; third-party headers are SYSTEM and stay silent.
add_library(limpet_options INTERFACE)
target_compile_options(
  limpet_options INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wnon-virtual-dtor -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 misreads Eigen's and libstdc++'s inlined loops at -O2; Clang checks the same code without these.
  target_compile_options(limpet_options INTERFACE -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread
                                                  -Wno-maybe-uninitialized -Wno-restrict)
endif()
if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # It warns of types that one file keeps to itself whenever that file is not the one on the command line.
  target_compile_options(limpet_options INTERFACE -Wno-subobject-linkage)
endif()
# Equal input must give equal bits: no contraction that depends on inlining.
target_compile_options(limpet_options INTERFACE -ffp-contract=off)
if(LIMPET_SANITIZE)
  target_compile_options(limpet_options INTERFACE -fsanitize=${LIMPET_SANITIZE} -fno-omit-frame-pointer
                                                  -fno-sanitize-recover=all)
  target_link_options(limpet_options INTERFACE -fsanitize=${LIMPET_SANITIZE})
endif()
target_include_directories(limpet_options INTERFACE "${CMAKE_SOURCE_DIR}" "${CMAKE_SOURCE_DIR}/share")

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  # Without this sloppiness ccache refuses whatever reads a precompiled header.
  set(CMAKE_CXX_COMPILER_LAUNCHER env "CCACHE_SLOPPINESS=pch_defines,time_macros" "${CCACHE_PROGRAM}")
endif()
