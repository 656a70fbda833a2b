#!/usr/bin/env bash
# Which commits since share/tools/lint_base have a subject of more than 72 characters, or, merges aside, no body that says why.
set -euo pipefail
cd "$(dirname "$0")/../.."
base="$(cat share/tools/lint_base)"
git cat-file -e "$base^{commit}" 2>/dev/null || { echo "subjects: $base is no commit known here" >&2; exit 0; }
status=0
while IFS= read -r commit; do
  subject="$(git log -1 --format=%s "$commit")"
  if [ "${#subject}" -gt 72 ]; then
    echo "subjects: $subject: ${#subject} characters; allowed: 72" >&2
    status=1
  fi
  if [ -z "$(git log -1 --format=%b "$commit")" ] && ! git rev-parse --quiet --verify "$commit^2" >/dev/null; then
    echo "subjects: $subject: no body says why" >&2
    status=1
  fi
done < <(git rev-list "$base..HEAD")
exit "$status"
