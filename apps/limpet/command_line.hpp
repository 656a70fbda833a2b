// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace limpet {

/// The whole `limpet` command, its name not among the words: runs a verb and says on stderr what
/// went wrong, with nothing in it that a terminal obeys. The exit code: 0 ok, 1 failed, 2 usage or
/// configuration, 3 refused.
[[nodiscard]] int RunCommandLine(const std::vector<std::string>& words);

}  // namespace limpet
