// SPDX-License-Identifier: MIT
#pragma once

namespace limpet {

/// How every command of limpet ends: 0 ok, 1 failed, 2 usage or configuration, 3 refused by a
/// check.
enum ExitCode : int { kOk = 0, kFailed = 1, kUsage = 2, kRefused = 3 };

}  // namespace limpet
