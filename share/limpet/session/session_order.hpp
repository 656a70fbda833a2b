// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace limpet {

/// The order in which sessions of a run are told of: discovery, change, then others by name.
void SortSessions(std::vector<std::string>& sessions);

}  // namespace limpet
