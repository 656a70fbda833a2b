// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace limpet {

/// One child process.
struct ChildRun {
  std::vector<std::string> args;  ///< without the program's name
  std::filesystem::path log;      ///< its stdout and stderr
  /// A path, or a name to be looked up in PATH; empty: the very file that runs here, also after the
  /// program was built anew.
  std::string program{};
};

/// Starts it. If this process is killed, `signal_if_orphaned` is sent to the child. Throws
/// std::runtime_error if no process can be started; a program that is not there ends with 127.
[[nodiscard]] pid_t StartChild(const ChildRun& run, int signal_if_orphaned);

/// The exit code if the child has ended, 128 + signal when killed by one.
[[nodiscard]] std::optional<int> ReapChild(pid_t child);
/// Waits for its end.
int WaitForChild(pid_t child);

/// This program's file.
[[nodiscard]] std::filesystem::path OwnProgram();

}  // namespace limpet
