#!/usr/bin/env bash
# What a compiler of another make and clang-tidy say of the code. Clang reads every file on its own, so that an #include
# which a neighbour in a unity build, or another compiler's headers, would hide is missing here, and clang-tidy holds it
# to .clang-tidy in the same go.
# What was clean stays so until a file that it reads changes. Two places know: share/tools/lint_base names the commit
# whose every file was read and found clean, so that a fresh clone reads what has changed since; and ~/.cache/limpet/lint
# what this machine has read. A reading that leaves nothing out, of all that is committed, writes lint_base anew; with
# --all it trusts the cache alone. The newest files come first; with LIMPET_LINT_SECONDS nothing is begun after so many,
# what is left is counted and said, and where lint_base is known that is a failure.
set -euo pipefail
cd "$(dirname "$0")/../.."
root=$PWD
clean="${XDG_CACHE_HOME:-$HOME/.cache}/limpet/lint"
base_file="$root/share/tools/lint_base"
findings="$root/build-lint/findings"
deadline=$((EPOCHSECONDS + ${LIMPET_LINT_SECONDS:-1000000}))
commands="$root/build-lint/alone"
plugin="$root/build-lint/own_code.so"
export root clean findings deadline commands plugin

configure() { # compile commands, by Clang
  cmake -S "$root" -B "$commands" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER=clang++-14 \
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DBUILD_TESTING=ON >"$commands.log" 2>&1 || { cat "$commands.log" >&2; return 1; }
  rm -f "$commands.log"
}

prepare() { # what every file is read with: precompiled headers and the plugin
  ninja -C "$commands" --quiet limpet_precompiled limpet_precompiled_quick limpet_precompiled_tests
  clang++-14 -std=c++17 -O1 -fno-rtti -fPIC -shared -I/usr/lib/llvm-14/include share/tools/own_code.cpp -o "$plugin"
}

newest_first() { # compile commands: those of files that changed last come first
  git log --format= --name-only --diff-filter=AM >build-lint/newest
  awk -v root="$root/" '
    NR == FNR { if (!($0 in rank)) rank[$0] = ++n; next }
    { file = $0; sub(".* -c ", "", file); sub(root, "", file)
      printf "%d\t%s\n", file in rank ? rank[file] : n + 1, $0 }' build-lint/newest - | sort -n | cut -f 2-
}

is_base_known() { git cat-file -e "$(cat "$base_file" 2>/dev/null)^{commit}" 2>/dev/null; }

code_of() { # of a text of C++: all but its comments, and those of them that clang-tidy heeds
  local text
  text="$(cat)"
  c++ -std=c++20 -fpreprocessed -dD -E -P -x c++ - <<<"$text" 2>/dev/null && { grep -oE '// *(NOLINT|namespace).*' <<<"$text" || true; }
}

is_new_comments_alone() { # file: it differs from what it was at lint_base, but by comments only
  local now
  case "$1" in *.cpp | *.hpp) ;; *) return 1 ;; esac
  [ -f "$1" ] && now="$(code_of <"$1")" && [ "$now" = "$(git show "$(cat "$base_file"):$1" 2>/dev/null | code_of)" ]
}

changed_files() { # since lint_base, committed or not, by more than comments
  git diff --name-only "$(cat "$base_file")" | while IFS= read -r file; do
    is_new_comments_alone "$file" || printf '%s\n' "$file"
  done
  git ls-files --others --exclude-standard
}

with_includers() { # list of files: they, and all that include one of them, at whatever remove
  awk -F '[:"]' '
    FILENAME == ARGV[1] { reached[$0]; queue[n++] = $0; next }
    { includers[$3] = includers[$3] ":" $1 }
    END {
      for (i = 0; i < n; ++i) {
        print queue[i]
        for (name = queue[i]; name != ""; name = index(name, "/") ? substr(name, index(name, "/") + 1) : "") {
          count = split(includers[name], files, ":")
          for (k = 2; k <= count; ++k) if (!(files[k] in reached)) { reached[files[k]]; queue[n++] = files[k] }
        }
      }
    }' "$1" <(git grep --untracked -oE '^#include "[^"]+"' -- '*.cpp' '*.hpp')
}

to_read() { # compile commands: those of files that read something that has changed since lint_base
  changed_files >build-lint/changed
  if grep -qE '^(\.clang-tidy|share/cmake/.*|share/tools/(own_code\.cpp|lint\.sh))$' build-lint/changed; then cat; return; fi
  awk -v root="$root/" '
    FILENAME == ARGV[1] { wanted[root $0]; next }
    { file = $0; sub(".* -c ", "", file) }
    file in wanted' <(with_includers build-lint/changed) -
}

compile_commands() { # one per line, as a shell reads it; not those of the precompiled headers
  sed -n 's/^ *"command": "\(.*\)",$/\1/p' "$commands/compile_commands.json" | grep -v ' -c [^ ]*precompiled[^ ]*$' |
    sed 's/\\\(["\\]\)/\1/g'
}

texts_of() { # compile command: all files of ours that it reads, one after the other
  eval "${1/ -o * -c / -MM }" | tr -s ' \\' '\n' | grep "^$root/" | grep -v "^$root/build" | sort -u | xargs cat
}

# Not of tests: fixtures are made and destroyed by googletest alone; a test sets its environment before it has threads;
# texts that turn round, that are huge, or the same call twice are what some are about; how fast they are is no matter;
# a benchmark may end with an exception.
fixtures=-bugprone-exception-escape,-bugprone-string-constructor,-bugprone-suspicious-missing-comma
fixtures+=,-concurrency-mt-unsafe,-cppcoreguidelines-special-member-functions
fixtures+=,-cppcoreguidelines-virtual-class-destructor,-misc-misleading-bidirectional,-misc-redundant-expression
fixtures+=,-modernize-use-equals-delete,-modernize-use-nodiscard,-performance-*

tidy() { # file
  local checks=()
  case "$1" in "$root"/tests/*) checks=(--checks="$fixtures") ;; esac
  clang-tidy-14 --load="$plugin" -p "$commands" --quiet --config-file="$root/.clang-tidy" "${checks[@]}" "$1" 2>&1 |
    sed '/warnings\{0,1\}.* generated\.$/d'
}

look_at() { # compile command: unless what it reads was clean, or the time is over
  local key file="${1##* -c }"
  if [ "$EPOCHSECONDS" -ge "$deadline" ]; then echo left >>"$findings"; return 0; fi
  key="$clean/$( (echo "$1" && cat "$root/.clang-tidy" "$root/share/tools/own_code.cpp" && texts_of "$1") |
    sha256sum | cut -d ' ' -f 1)"
  [ ! -e "$key" ] || return 0
  if tidy "$file"; then : >"$key"; else echo bad >>"$findings"; fi
}
export fixtures
export -f texts_of tidy look_at

mkdir -p build-lint "$clean"
find "$clean" -type f -mtime +30 -delete
: >"$findings"
configure
select=cat
if [ "${1:-}" != --all ]; then
  if is_base_known; then select=to_read; else echo "lint: share/tools/lint_base names no commit known here" >&2; fi
fi
compile_commands | "$select" | newest_first >build-lint/reading
echo "lint: $(wc -l <build-lint/reading) files to read" >&2
[ ! -s build-lint/reading ] || prepare
tr '\n' '\0' <build-lint/reading | xargs -0 -r -P "$(nproc)" -n 1 bash -o pipefail -c 'look_at "$1"' -
left="$(grep -c left "$findings" || true)"
[ "$left" -eq 0 ] || echo "lint: $left files left for another time" >&2
if grep -q bad "$findings" || { [ "$left" -gt 0 ] && [ "$select" = to_read ]; }; then exit 1; fi
[ "$left" -gt 0 ] || [ -n "$(git status --porcelain)" ] || git rev-parse HEAD >"$base_file"
