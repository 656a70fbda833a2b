// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace limpet {

/// `limpet key new|show <file>`: makes a key for sealed routes, or tells which one a file holds.
int RunKey(std::span<const std::string> args);

}  // namespace limpet
