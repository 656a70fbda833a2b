// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace limpet {

/// Launches the processes of a mission file and watches over them until they end, a signal comes,
/// or a variable is heard. `caller` is what help calls it: pLaunch, or limpet launch.
/// Exit codes: 0 ended in order, 1 a process could not be kept alive, 2 command line or mission,
/// 3 a mission that cannot work.
[[nodiscard]] int RunLaunch(const std::string& caller, const std::vector<std::string>& args);

}  // namespace limpet
