#!/usr/bin/env bash
# Branches of pSafety's logic (the table, the ladder, what they are fed with, the app) that their unit tests have gone each way, as
# Clang counts conditions in the source: what only an exception would take is none. Names each way not gone; fails if there is one.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=build-coverage
export CCACHE_BASEDIR="$PWD" CCACHE_NOHASHDIR=1
mkdir -p "$build"
rm -rf "$build/branches"
{
  cmake --preset coverage && cmake --build "$build" --target unit_safety unit_pSafety
  for test in unit_safety unit_pSafety; do
    LLVM_PROFILE_FILE="$build/branches/$test.profraw" "$build/bin/$test"
  done
} >"$build/branches.log" 2>&1 || { tail -n 40 "$build/branches.log" >&2; exit 1; }
llvm-profdata merge -o "$build/branches.profdata" "$build"/branches/*.profraw
# A record: line, which condition on it (one of a template: in each use), way (even: it holds), how often it was gone; `-`: never.
llvm-cov export -format=lcov -instr-profile "$build/branches.profdata" \
  "$build/bin/unit_safety" -object "$build/bin/unit_pSafety" 2>"$build/branches.log" |
  awk -v root="$PWD/" -F '[:,]' '
    $1 == "SF" { file = $2; sub("^" root, "", file); sub("^build-coverage/[.][.]/", "", file) }
    $1 == "BRDA" && file ~ /^(share\/limpet\/safety|apps\/pSafety)\// {
      way = sprintf("%s:%d: condition %d %s", file, $2, $3 + 1, $4 % 2 ? "never fails" : "never holds")
      gone[way] += $5 == "-" ? 0 : $5
    }
    END {
      for (way in gone) { ++all; if (gone[way] > 0) ++taken; else print way | "sort -t: -k1,1 -k2,2n" }
      close("sort -t: -k1,1 -k2,2n")
      if (!all) { print "no branch was counted"; exit 1 }
      printf "pSafety: %d of %d branches gone, %.1f %%\n", taken, all, 100 * taken / all
      exit taken < all
    }'
