// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace limpet {

/// True for the plain name of a MOOS process: p, i or u and a capital letter, no path; and for the
/// databases. A mission starts no other program unless the launcher is told --allow-outside.
[[nodiscard]] bool IsNameOfMoosProcess(std::string_view name);

}  // namespace limpet
