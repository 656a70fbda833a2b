// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/scoring/scorer.hpp"

namespace limpet {

/// Where a session's time went: "ALIGN 72, DIVE 24, SURVEY 890" [s]; empty if no phase is known. As
/// a log has the names: still to be escaped for a page.
[[nodiscard]] std::string PhaseSentence(const SessionScore& session);

}  // namespace limpet
