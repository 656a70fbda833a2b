#!/usr/bin/env bash
# What a compiler of another make and clang-tidy say of the code. Every file is read by Clang on its own, so that an
# #include which a neighbour in a unity build, or another compiler's headers, would hide is missing here; every file of
# the product is held to .clang-tidy, eight at a time, since most of the time goes into the headers of others.
# What was clean stays so until a file that it reads changes: ~/.cache/limpet/tidy knows.
set -euo pipefail
cd "$(dirname "$0")/../.."
root=$PWD
jobs="$(nproc)"
clean="${XDG_CACHE_HOME:-$HOME/.cache}/limpet/tidy"
export root clean

prepare() { # folder cmake-argument...: compile commands and precompiled headers, by Clang
  local folder="$root/$1" targets=(limpet_precompiled)
  shift
  cmake -S "$root" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER=clang++-14 \
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON "$@" >"$folder.log" 2>&1 || { cat "$folder.log" >&2; return 1; }
  rm -f "$folder.log"
  case " $* " in *BUILD_TESTING=ON*) targets+=(limpet_precompiled_tests) ;; esac
  ninja -C "$folder" --quiet "${targets[@]}"
}

commands() { # folder: one compile command per line, as a shell reads it; not those of the precompiled headers
  sed -n 's/^ *"command": "\(.*\)",$/\1/p' "$1/compile_commands.json" | grep -v ' -c [^ ]*precompiled[^ ]*$' |
    sed 's/\\\(["\\]\)/\1/g'
}

read_alone() { # compile command: only the front end, which finds all that can be wrong
  eval "${1/ -o * -c / -fsyntax-only }"
}

tidy() { # compile command of a batch: silent if it is clean, or was so with the same text
  local batch="${1##* -c }" key
  key="$(eval "${1/ -o * -c / -MM }" | tr -s ' \\' '\n' | grep "^$root/" | grep -v "^$root/build" | sort -u |
    xargs cat "$root/.clang-tidy" "$batch" | sha256sum | cut -d ' ' -f 1)"
  [ ! -e "$clean/$key" ] || return 0
  clang-tidy-14 -p "$root/build-lint/unity" --quiet --config-file="$root/.clang-tidy" "$batch" 2>/dev/null && : >"$clean/$key"
}
export -f read_alone tidy

mkdir -p build-lint "$clean"
find "$clean" -type f -mtime +30 -delete
prepare build-lint/alone -DBUILD_TESTING=ON
commands build-lint/alone | tr '\n' '\0' | xargs -0 -P "$jobs" -n 1 bash -c 'read_alone "$1"' -
prepare build-lint/unity -DBUILD_TESTING=OFF -DCMAKE_UNITY_BUILD=ON
commands build-lint/unity | tr '\n' '\0' | xargs -0 -P "$jobs" -n 1 bash -c 'tidy "$1"' -
