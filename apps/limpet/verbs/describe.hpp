// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace limpet {

/// `limpet describe [parameters | variables [mission folder] | NAME...]`: what a mission file may
/// set, and every variable with its type, unit, frame, rate, writers and readers.
int RunDescribe(std::span<const std::string> args);

}  // namespace limpet
