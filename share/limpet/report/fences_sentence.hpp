// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/scoring/scorer.hpp"

namespace limpet {

/// How far the vehicle truly left its region or entered a keep-out zone; empty if it did neither.
[[nodiscard]] std::string FencesSentence(const SessionScore& session);

}  // namespace limpet
