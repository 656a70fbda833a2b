#!/usr/bin/env bash
# What a compiler of another make and clang-tidy say of the code. Every file is read by Clang on its own, so that an
# #include which a neighbour in a unity build, or another compiler's headers, would hide is missing here; every file is
# held to .clang-tidy, eight at a time, since most of the time goes into the headers of others.
# What was clean stays so until a file that it reads changes: ~/.cache/limpet/lint knows. The newest files come first;
# with LIMPET_LINT_SECONDS nothing is begun after so many, and what is left for another time is counted and said.
set -euo pipefail
cd "$(dirname "$0")/../.."
root=$PWD
clean="${XDG_CACHE_HOME:-$HOME/.cache}/limpet/lint"
findings="$root/build-lint/findings"
deadline=$((EPOCHSECONDS + ${LIMPET_LINT_SECONDS:-1000000}))
export root clean findings deadline

prepare() { # folder cmake-argument...: compile commands and precompiled headers, by Clang
  local folder="$root/$1" targets=(limpet_precompiled)
  shift
  cmake -S "$root" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER=clang++-14 \
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON "$@" >"$folder.log" 2>&1 || { cat "$folder.log" >&2; return 1; }
  rm -f "$folder.log"
  case " $* " in *BUILD_TESTING=ON*) targets+=(limpet_precompiled_tests) ;; esac
  ninja -C "$folder" --quiet "${targets[@]}"
}

newest_first() { # compile commands: those of files that changed last come first
  git log --format= --name-only --diff-filter=AM >build-lint/newest
  awk -v root="$root/" '
    NR == FNR { if (!($0 in rank)) rank[$0] = ++n; next }
    { file = $0; sub(".* -c ", "", file); sub(root, "", file)
      printf "%d\t%s\n", file in rank ? rank[file] : n + 1, $0 }' build-lint/newest - | sort -n | cut -f 2-
}

tests_last() { # compile commands: what time is left when the product has been looked at goes to its tests
  awk -v of_tests="$root/build-lint/unity/tests/" '{ printf "%d\t%s\n", (index($0, of_tests) > 0), $0 }' |
    sort -s -n -k 1,1 | cut -f 2-
}

commands() { # folder: one compile command per line, as a shell reads it; not those of the precompiled headers
  sed -n 's/^ *"command": "\(.*\)",$/\1/p' "$1/compile_commands.json" | grep -v ' -c [^ ]*precompiled[^ ]*$' |
    sed 's/\\\(["\\]\)/\1/g'
}

once() { # key check argument...: runs the check unless what has this key was clean, or the time is over
  local key="$clean/$1"
  shift
  [ ! -e "$key" ] || return 0
  if [ "$EPOCHSECONDS" -ge "$deadline" ]; then echo left >>"$findings"; return 0; fi
  if "$@"; then : >"$key"; else echo bad >>"$findings"; fi
}

syntax() { eval "${1/ -o * -c / -fsyntax-only }"; } # compile command: only the front end, which finds all there is

texts_of() { # compile command: all files of ours that it reads, one after the other
  eval "${1/ -o * -c / -MM }" | tr -s ' \\' '\n' | grep "^$root/" | grep -v "^$root/build" | sort -u | xargs cat
}

read_alone() { # compile command
  if [ "$EPOCHSECONDS" -ge "$deadline" ]; then echo left >>"$findings"; return 0; fi
  once "$( (echo "$1" && texts_of "$1") | sha256sum | cut -d ' ' -f 1)" syntax "$1"
}

# Not of tests: fixtures are made and destroyed by googletest alone; a test sets its environment before it has threads;
# texts that turn round, that are huge, or the same call twice are what some are about; how fast they are is no matter;
# a benchmark may end with an exception.
fixtures=-bugprone-exception-escape,-bugprone-string-constructor,-bugprone-suspicious-missing-comma
fixtures+=,-concurrency-mt-unsafe,-cppcoreguidelines-special-member-functions
fixtures+=,-cppcoreguidelines-virtual-class-destructor,-misc-misleading-bidirectional,-misc-redundant-expression
fixtures+=,-modernize-use-equals-delete,-modernize-use-nodiscard,-performance-*

run_tidy() { # file; two of a batch may call the same thing by the same name, alone each is read with -Wshadow
  local checks=()
  case "$1" in "$root"/build-lint/unity/tests/*) checks=(--checks="$fixtures") ;; esac
  clang-tidy-14 -p "$root/build-lint/unity" --quiet --config-file="$root/.clang-tidy" --extra-arg=-Wno-shadow \
    "${checks[@]}" "$1" 2>/dev/null
}

tidy() { # compile command of a batch
  local batch="${1##* -c }"
  if [ "$EPOCHSECONDS" -ge "$deadline" ]; then echo left >>"$findings"; return 0; fi
  once "$( (cat "$root/.clang-tidy" "$batch" && texts_of "$1") | sha256sum | cut -d ' ' -f 1)" run_tidy "$batch"
}
export fixtures
export -f texts_of once syntax read_alone run_tidy tidy

each() { # check: of every compile command that comes in, on all cores
  tr '\n' '\0' | xargs -0 -r -P "$(nproc)" -n 1 bash -c "$1"' "$1"' -
}

mkdir -p build-lint "$clean"
find "$clean" -type f -mtime +30 -delete
: >"$findings"
prepare build-lint/alone -DBUILD_TESTING=ON
commands build-lint/alone | newest_first | each read_alone
prepare build-lint/unity -DBUILD_TESTING=ON -DCMAKE_UNITY_BUILD=ON
commands build-lint/unity | tests_last | each tidy
left="$(grep -c left "$findings" || true)"
[ "$left" -eq 0 ] || echo "lint: $left files or batches left for another time" >&2
! grep -q bad "$findings"
