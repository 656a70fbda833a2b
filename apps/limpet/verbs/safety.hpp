// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace limpet {

/// `limpet safety list [mission]`: the table of safety rules, with the limits of a mission.
int RunSafety(std::span<const std::string> args);

}  // namespace limpet
