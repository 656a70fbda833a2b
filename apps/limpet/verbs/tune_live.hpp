// SPDX-License-Identifier: MIT
#pragma once

#include "apps/limpet/cli.hpp"

namespace limpet {

/// `limpet tune --live <mission.moos> behavior.key=value`, and its `--undo`: 1 if the helm does not
/// apply it. Throws UsageError, ConfigError, NoCommunity.
[[nodiscard]] int TuneLive(const Arguments& given);

}  // namespace limpet
