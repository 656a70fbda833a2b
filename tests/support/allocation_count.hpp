// SPDX-License-Identifier: MIT
#pragma once

namespace limpet {

/// How often memory was allocated by `new` since the program began, in all threads. A program that
/// is linked with this counts.
[[nodiscard]] long AllocationCount();

}  // namespace limpet
