// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <sys/types.h>

namespace limpet {

/// Memory of a process that is in RAM now, shared pages too [MiB]; nothing if there is no such
/// process, or no /proc.
[[nodiscard]] std::optional<double> ResidentMib(pid_t process);

}  // namespace limpet
