// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace limpet {

/// `limpet describe [parameters | variables [mission folder] | warnings | NAME...]`: what a mission
/// file may set, every variable with its type, unit, frame, rate, writers and readers, and every
/// warning with its severity, meaning, what to do and when it clears.
int RunDescribe(std::span<const std::string> args);

}  // namespace limpet
