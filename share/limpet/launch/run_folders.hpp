// SPDX-License-Identifier: MIT
// Where a launch leaves what it makes. A dive's folder is never written to by a later launch.
//   runs/table1-live/discovery    the first launch
//   runs/table1-live/change       a launch with --session=change: compares with that discovery
//   runs/table1-live-2/discovery  the next discovery
#pragma once

#include <filesystem>

#include "limpet/launch/launch_plan.hpp"

namespace limpet {

struct RunFolders {
  std::filesystem::path run;    ///< the session's folder is in it
  std::filesystem::path prior;  ///< of the former session; empty if the session has none
};

/// The folders of a launch, from the present folder. Without --run_folder: the next numbered one if
/// this session was flown already. A later session compares with the discovery of the latest dive,
/// beside which it is kept if there is room. Throws ConfigError if a folder that is asked for holds
/// a former launch, or if there is no dive to compare with. Creates nothing.
[[nodiscard]] RunFolders ChooseRunFolders(const LaunchCommand& command);

}  // namespace limpet
