// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/scoring/scorer.hpp"

namespace limpet {

/// The least way that shows all of the band's top, and how much of it 95 % of the band took; empty
/// where there is no such way.
[[nodiscard]] std::string BoundSentence(const SessionScore& session);

/// What of the band was not seen, by reason; empty if that is less than a thousandth.
[[nodiscard]] std::string UnseenSentence(const UnseenScore& unseen);

}  // namespace limpet
