// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/scoring/opi_score.hpp"

namespace limpet {

/// What an object that nothing was decided of may be: `open`, with its two likeliest statuses if
/// looks say anything about it.
[[nodiscard]] std::string OpenText(const ChangeScore& change);

}  // namespace limpet
