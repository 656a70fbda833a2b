#!/usr/bin/env bash
# Every C++ file of the tree as .clang-format has it: says where one is not. --fix: makes it so.
# Only version 14 counts; another one breaks lines in other places.
set -euo pipefail
cd "$(dirname "$0")/../.."
program=clang-format-14
action=(--dry-run -Werror)
[ "${1:-}" != --fix ] || action=(-i)
git ls-files -z --cached --others --exclude-standard --deduplicate '*.cpp' '*.hpp' |
  while IFS= read -r -d '' file; do [ ! -e "$file" ] || printf '%s\0' "$file"; done |
  xargs -0 -P "$(nproc)" -n 32 "$program" "${action[@]}"
