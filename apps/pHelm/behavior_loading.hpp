// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/app/app.hpp"
#include "limpet/helm/answer_watch.hpp"
#include "limpet/helm/helm_params.hpp"
#include "limpet/mission/behavior_file.hpp"

namespace limpet {

/// The behavior files of a helm as they are on disk now, with what its block sets in them. Loads
/// behaviors of shared objects first. Throws ConfigError.
[[nodiscard]] std::vector<BehaviorFile> LoadBehaviorFiles(const AppContext& context,
                                                          const HelmParams& params);

/// None embedded: nobody is late there, so that runs repeat.
[[nodiscard]] RealClock ClockOf(const AppContext& context);

}  // namespace limpet
