// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace limpet {

/// `limpet tables <mission folder> --runs N [--jobs J] [--out DIR] [options of survey]`: one survey
/// per seed in processes of their own, then the paper's tables beside ours. Returns the exit code:
/// 0 when every seed left a report and enough of them keep the bounds of expect.yaml.
int RunTables(std::span<const std::string> args);

}  // namespace limpet
