// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include <sys/types.h>

#include "limpet/core/units.hpp"

namespace limpet {

/// Time that a process has had on processors since its start, of all its threads together; nothing
/// if there is no such process, or no /proc.
[[nodiscard]] std::optional<Seconds> ProcessorTime(pid_t process);

namespace internal {
/// A process's time on processors in ticks of the system's clock, of what /proc/<pid>/stat says;
/// nothing of other text.
[[nodiscard]] std::optional<double> ProcessorTicksIn(std::string_view stat);
}  // namespace internal

}  // namespace limpet
