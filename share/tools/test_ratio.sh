#!/usr/bin/env bash
# Lines of tests, without benchmarks, to lines of what they test; fails below 0.6.
set -euo pipefail
cd "$(dirname "$0")/../.."
lines() { git ls-files -z "$@" | xargs -0 cat | wc -l; }
tests="$(lines 'tests/*.cpp' 'tests/*.hpp' ':!tests/bench')"
product="$(lines '*.cpp' '*.hpp' ':!tests')"
awk -v tests="$tests" -v product="$product" 'BEGIN { printf "%.2f (%d lines of tests, %d of product)\n", tests / product, tests, product; exit tests < 0.6 * product }'
