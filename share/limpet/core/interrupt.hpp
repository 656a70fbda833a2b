// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>

namespace limpet {

/// Set by a program's signal handler: long work stops at its next step and ends in order.
inline std::atomic<bool> interrupt_requested{false};

}  // namespace limpet
