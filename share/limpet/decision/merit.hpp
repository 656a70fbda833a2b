// SPDX-License-Identifier: MIT
// The arithmetic by which an option wins. The helm decides with it, and whoever explains or scores
// a decision computes it again from the bids: the same operations in the same order, so that the
// result is the same to the last bit.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "limpet/topics/mission.hpp"

namespace limpet {

/// Sum of values times weights, in the order of the bids [m of path, or nats].
[[nodiscard]] double TotalOf(std::span<const WeightedBid> bids);
/// What a total is divided by to rank an option per metre [m]: its length, or the one that it
/// shares with others; at least a metre.
[[nodiscard]] double RateLengthOf(const BiddenOption& option);
/// `total` per metre of an option, or of the length that it shares with others; less than a metre
/// counts as a metre.
[[nodiscard]] double RateOf(double total, const BiddenOption& option);
/// What options are ranked by.
[[nodiscard]] double MeritOf(const BiddenOption& option, OptionOrder order);
/// A bid's part of its option's merit.
[[nodiscard]] double ShareOf(const WeightedBid& bid, const BiddenOption& option, OptionOrder order);

/// The first veto; null if nobody forbids the option.
[[nodiscard]] const WeightedBid* VetoOn(const BiddenOption& option);
/// What `behavior` bid; null if it had no opinion.
[[nodiscard]] const WeightedBid* BidOf(const BiddenOption& option, std::string_view behavior);
/// True if `a` ranks before `b`: vetoed ones last, then by merit.
[[nodiscard]] bool IsBetter(const BiddenOption& a, const BiddenOption& b, OptionOrder order);
/// The best option that nobody forbids, among equals the first; nothing if there is none.
[[nodiscard]] std::optional<std::size_t> ChoiceOf(const HelmBids& bids);

}  // namespace limpet
