// SPDX-License-Identifier: MIT
#pragma once

namespace limpet {

inline constexpr double kBytesPerMib = 1024.0 * 1024.0;

}  // namespace limpet
