// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace limpet {

/// `limpet check <mission folder | .moos | .bhv> [--json]`: every problem of a mission, none of it
/// run. Exit code 2 for what cannot be read, 3 for what cannot work; notes change nothing.
int RunCheck(std::span<const std::string> args);

}  // namespace limpet
