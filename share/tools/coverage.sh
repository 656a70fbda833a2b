#!/usr/bin/env bash
# Lines that the tests of the preset `coverage` have run, per library and in all: `./limpet nightly` prints it.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=build-coverage
llvm-profdata merge -o "$build/tests.profdata" "$build"/profiles/*.profraw
objects=()
for program in "$build"/bin/*; do
  if [ -x "$program" ]; then objects+=(-object "$program"); fi
done
llvm-cov report -ignore-filename-regex="(^/usr|/tests/|/build-)" -instr-profile "$build/tests.profdata" "${objects[@]}" |
  awk -v root="$PWD/" '
    { sub("^" root, "") }
    NF >= 10 && $1 ~ /^(apps|behaviors|estimation|share\/limpet)\// {
      depth = split($1, part, "/")
      library = part[1] == "share" ? part[3] : depth > 2 ? part[2] : part[1]
      lines[library] += $8; missed[library] += $9; all += $8; all_missed += $9
    }
    function row(rank, name, of, without) {
      printf "%d  %-16s %6d lines, %5.1f %% run\n", rank, name, of, 100 * (of - without) / (of ? of : 1)
    }
    END {
      for (name in lines) row(1, name, lines[name], missed[name])
      row(2, "in all", all, all_missed)
    }' | sort | cut -c2-
