// SPDX-License-Identifier: MIT
#include "limpet/decision/deciding_bid.hpp"

#include <algorithm>
#include <utility>

#include "limpet/decision/merit.hpp"

namespace limpet {
namespace {

/// What a behavior adds to that by which the helm ranks an option.
double ContributionTo(const BiddenOption& option, const std::string& behavior, OptionOrder order) {
  const WeightedBid* bid = BidOf(option, behavior);
  return bid == nullptr ? 0.0 : ShareOf(*bid, option, order);
}

/// The option that would have won without `behavior`.
const BiddenOption& WinnerWithout(const HelmBids& bids, const std::string& behavior) {
  const BiddenOption* best = &bids.options.front();
  const auto merit = [&](const BiddenOption& option) {
    return MeritOf(option, bids.order) - ContributionTo(option, behavior, bids.order);
  };
  for (const BiddenOption& option : bids.options) {
    if (VetoOn(option) == nullptr && merit(option) > merit(*best) + 1e-9) best = &option;
  }
  return *best;
}

double DecisiveGain(const HelmBids& bids, const std::string& behavior) {
  const BiddenOption& chosen = bids.options.front();
  const double given = ContributionTo(chosen, behavior, bids.order);
  const BiddenOption& other = WinnerWithout(bids, behavior);
  return &other == &chosen ? given
                           : std::max(given, given - ContributionTo(other, behavior, bids.order));
}

BidPurpose PurposeOf(const Bid& bid) {
  if (bid.why.empty()) return BidPurpose::kOther;
  const std::string& reason = bid.why.front().name;
  if (reason == "useful") return BidPurpose::kCover;
  if (reason == "looks_worth") return BidPurpose::kLook;
  if (reason == "to_go" || reason == "overrun") return BidPurpose::kHome;
  return BidPurpose::kOther;
}

bool BidsAnything(const HelmBids& bids, const std::string& behavior) {
  return std::ranges::any_of(bids.options, [&](const BiddenOption& option) {
    return ContributionTo(option, behavior, bids.order) != 0.0;
  });
}

}  // namespace

std::optional<DecidingBid> DecidingBidOf(const HelmBids& bids) {
  if (!ChoiceOf(bids)) return std::nullopt;
  std::optional<DecidingBid> deciding;
  double most = 0.0;
  for (const WeightedBid& bid : bids.options.front().bids) {
    if (!BidsAnything(bids, bid.behavior)) continue;  // e.g. one that only forbids
    const double weight = DecisiveGain(bids, bid.behavior);
    if (deciding && weight <= most) continue;
    deciding = DecidingBid{bid.behavior, PurposeOf(bid.bid)};
    most = weight;
  }
  return deciding;
}

}  // namespace limpet
