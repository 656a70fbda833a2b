// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace limpet {

/// `limpet check <mission folder> [--json]`: every problem of a mission, none of it run. Exit code
/// 2 for what does not parse, 3 for what cannot work.
int RunCheck(std::span<const std::string> args);

}  // namespace limpet
