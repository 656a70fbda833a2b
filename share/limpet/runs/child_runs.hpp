// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace limpet {

/// One child process of this program.
struct ChildRun {
  std::vector<std::string> args;  ///< without the program's name
  std::filesystem::path log;      ///< its stdout and stderr
};

/// How a child ended.
struct ChildEnd {
  std::size_t index = 0;  ///< in the list of runs
  int exit_code = 0;      ///< 128 + signal when killed by one
};

/// Runs the own executable once per entry, `jobs` at a time, in order. `on_end` is called in this
/// thread as each ends; it returns false to stop. Then, or when the user interrupts, no more are
/// started and those running are asked to end; their ends are not reported. False if it came to
/// that. Throws std::runtime_error when no process can be started; none is left running.
bool RunChildren(const std::vector<ChildRun>& runs, int jobs,
                 const std::function<bool(const ChildEnd&)>& on_end);

}  // namespace limpet
