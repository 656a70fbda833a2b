// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/figures/figures.hpp"
#include "limpet/scoring/scorer.hpp"

namespace limpet {

/// report.html: one file that needs no other and no network. `figures` has one list per session of
/// `run`, in its order.
[[nodiscard]] std::string HtmlPage(const RunScore& run,
                                   const std::vector<std::vector<Figure>>& figures);

}  // namespace limpet
