// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "limpet/sweeps/child_process.hpp"

namespace limpet {

/// How a child ended.
struct ChildEnd {
  std::size_t index = 0;  ///< in the list of runs
  int exit_code = 0;      ///< 128 + signal when killed by one
};

/// Called as each child ends; it returns false to stop.
using OnChildEnd = std::function<bool(const ChildEnd&)>;

/// Runs each entry once, `jobs` at a time, in order. `on_end` is called in this thread. When it
/// says stop, or the user interrupts, no more are started and those running are asked to end; their
/// ends are not reported. False if it came to that. Throws std::runtime_error when no process can
/// be started; none is left running, also if this process is killed.
[[nodiscard]] bool RunChildren(const std::vector<ChildRun>& runs, int jobs,
                               const OnChildEnd& on_end);

}  // namespace limpet
