// SPDX-License-Identifier: MIT
// Which landmarks may be an object of the former session although it is not decided: neither
// called that object nor called new.
#pragma once

#include <vector>

#include "estimation/matching/session_matching.hpp"
#include "limpet/objects/former_session.hpp"

namespace limpet {

/// Chance from which on a match is decided; a candidate with less than the rest is none.
inline constexpr double kDecidedMatch = 0.9;

/// Candidates of a landmark that was matched with others in `match`, there the one with index
/// `now`: by the assignments that rival the best one. Empty if that is decided.
[[nodiscard]] std::vector<FormerCandidate> RivalCandidates(const std::vector<FormerObject>& former,
                                                           const SessionMatch& match, int now);

/// Candidates of a landmark without a match, among the former objects that `is_taken` leaves: by
/// how far it is from where the offset puts them, with what is unknown of both places and of the
/// offset, against how dense new objects lie. `former`: each with its own covariance in its frame.
[[nodiscard]] std::vector<FormerCandidate> NearbyCandidates(const std::vector<FormerObject>& former,
                                                            const std::vector<bool>& is_taken,
                                                            const ObjectEstimate& landmark,
                                                            const SessionMatch& match,
                                                            const MatchingParams& params);

}  // namespace limpet
