// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/topics/mission.hpp"

namespace limpet {

/// The smallest change of one behavior's weight (`pwt`) that would have made another option win,
/// all bids and other weights as they were. Options that are worth the same to within rounding are
/// one: to go from one to the other is no flip.
struct Flip {
  std::string behavior;
  double weight = 0.0;      ///< in force
  double new_weight = 0.0;  ///< at least 0; with it `to` wins
  std::size_t to = 0;       ///< index of the option that wins then
};

/// The bids with another weight of `behavior`; totals and rates follow.
[[nodiscard]] HelmBids Reweighted(const HelmBids& bids, std::string_view behavior, double weight);

/// Nothing if the helm chose nothing, or no weight of this behavior leads to an option that
/// differs.
[[nodiscard]] std::optional<Flip> FlipOf(const HelmBids& bids, std::string_view behavior);

/// Flips that behaviors can make: of every one that bid on any option, in the order of their bids.
[[nodiscard]] std::vector<Flip> FlipsOf(const HelmBids& bids);

/// Behaviors that bid on any option, in the order of their bids.
[[nodiscard]] std::vector<std::string> BiddersOf(const HelmBids& bids);

}  // namespace limpet
