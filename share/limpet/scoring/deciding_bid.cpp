// SPDX-License-Identifier: MIT
#include "limpet/scoring/deciding_bid.hpp"

#include <algorithm>
#include <utility>

namespace limpet {
namespace {

/// What a behavior adds to the rate by which the helm ranks an option.
double ContributionTo(const BiddenOption& option, const std::string& behavior) {
  constexpr double kShortest = 1.0;  // as the helm divides [m]
  for (const OptionBid& bid : option.bids) {
    if (bid.behavior == behavior)
      return bid.weight * bid.value / std::max(option.length, kShortest);
  }
  return 0.0;
}

bool HasVeto(const BiddenOption& option) {
  return std::ranges::any_of(option.bids, [](const OptionBid& bid) { return bid.has_veto; });
}

/// The option that would have won without `behavior`.
const BiddenOption& WinnerWithout(const HelmBids& bids, const std::string& behavior) {
  const BiddenOption* best = &bids.options.front();
  const auto rate = [&](const BiddenOption& option) {
    return option.rate - ContributionTo(option, behavior);
  };
  for (const BiddenOption& option : bids.options) {
    if (!HasVeto(option) && rate(option) > rate(*best) + 1e-9) best = &option;
  }
  return *best;
}

double WeightOf(const HelmBids& bids, const std::string& behavior) {
  const BiddenOption& chosen = bids.options.front();
  const double given = ContributionTo(chosen, behavior);
  const BiddenOption& other = WinnerWithout(bids, behavior);
  return &other == &chosen ? given : std::max(given, given - ContributionTo(other, behavior));
}

BidPurpose PurposeOf(const OptionBid& bid) {
  const std::string reason = bid.why.substr(0, bid.why.find('='));
  if (reason == "useful") return BidPurpose::kCover;
  if (reason == "looks_worth") return BidPurpose::kLook;
  if (reason == "to_go" || reason == "overrun") return BidPurpose::kHome;
  return BidPurpose::kOther;
}

bool BidsAnything(const HelmBids& bids, const std::string& behavior) {
  return std::ranges::any_of(bids.options, [&](const BiddenOption& option) {
    return ContributionTo(option, behavior) != 0.0;
  });
}

}  // namespace

std::optional<DecidingBid> DecidingBidOf(const HelmBids& bids) {
  if (bids.options.empty() || HasVeto(bids.options.front())) return std::nullopt;
  std::optional<DecidingBid> deciding;
  double most = 0.0;
  for (const OptionBid& bid : bids.options.front().bids) {
    if (!BidsAnything(bids, bid.behavior)) continue;  // e.g. one that only forbids
    const double weight = WeightOf(bids, bid.behavior);
    if (deciding && weight <= most) continue;
    deciding = DecidingBid{bid.behavior, PurposeOf(bid)};
    most = weight;
  }
  return deciding;
}

}  // namespace limpet
