// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace limpet {

/// `limpet work <tasks.json>`: what the elements of a Slurm array run for `tables` and `tune`.
[[nodiscard]] int RunWork(std::span<const std::string> args);

}  // namespace limpet
