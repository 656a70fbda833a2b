// SPDX-License-Identifier: MIT
// Which landmarks of a saved session are objects of another one: what pNav decided on board, or
// decides now by the same rule.
#pragma once

#include <vector>

#include "limpet/session/saved_session.hpp"

namespace limpet {

/// True if session A was the former one that B flew with.
[[nodiscard]] bool WasFlownWith(const SavedSession& b, const SavedSession& a);

/// Landmarks of session B, matched with `prior`, which is session A's. If B was flown with A as its
/// former session they are as B kept them; else they are matched anew, with both joint covariances
/// and with pNav's parameters of the mission that B kept. Throws ConfigError if those are none.
[[nodiscard]] std::vector<Landmark> MatchedLandmarks(const SavedSession& a, const SavedSession& b,
                                                     const SessionPrior& prior);

}  // namespace limpet
