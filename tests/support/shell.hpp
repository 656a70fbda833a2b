// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdio>
#include <string>

#include <sys/wait.h>

namespace limpet {

struct ShellResult {
  int exit_code = -1;  ///< -1: it was killed, or there is no shell
  std::string text;    ///< standard output and error, as they came
};

/// What `command` says to a shell, in English.
inline ShellResult Shell(const std::string& command) {
  ShellResult result;
  std::FILE* const pipe = ::popen(("LC_ALL=C " + command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return result;
  std::array<char, 4096> piece{};
  while (std::fgets(piece.data(), piece.size(), pipe) != nullptr) {
    result.text += piece.data();
  }
  const int status = ::pclose(pipe);
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

}  // namespace limpet
