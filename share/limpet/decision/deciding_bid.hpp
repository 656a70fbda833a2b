// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "limpet/topics/mission.hpp"

namespace limpet {

/// What a behavior bids for, by the reasons that it gives.
enum class BidPurpose { kCover, kLook, kHome, kOther };

/// The behavior whose bid made the helm choose as it did.
struct DecidingBid {
  std::string behavior;  ///< its name in the mission
  BidPurpose purpose = BidPurpose::kOther;
};

/// Of the behaviors that bid on the chosen option, the one that weighs most: by what its bid gives
/// that option, per metre; or, if without it another listed option would have won, by how much more
/// it charges that one. So a path is a look at an object when looks are the larger part of its
/// worth, and the way home when being late costs more than what else there is to win. Who offered
/// the path does not matter. Nothing if no option is listed or nobody bid.
[[nodiscard]] std::optional<DecidingBid> DecidingBidOf(const HelmBids& bids);

}  // namespace limpet
