// SPDX-License-Identifier: MIT
#include "limpet/decision/flip.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/decision/merit.hpp"

namespace limpet {
namespace {

/// An option's merit as a straight line over the weight of one behavior.
struct MeritLine {
  double at_zero = 0.0;
  double slope = 0.0;
};

MeritLine LineOf(const BiddenOption& option, std::string_view behavior, OptionOrder order) {
  MeritLine line;
  for (const OptionBid& bid : option.bids) {
    if (bid.behavior == behavior) {
      OptionBid of_weight_1 = bid;
      of_weight_1.weight = 1.0;
      line.slope += ShareOf(of_weight_1, option, order);
    } else {
      line.at_zero += ShareOf(bid, option, order);
    }
  }
  return line;
}

std::optional<double> WeightOf(const HelmBids& bids, std::string_view behavior) {
  for (const BiddenOption& option : bids.options) {
    if (const OptionBid* bid = BidOf(option, behavior)) {
      return bid->weight;
    }
  }
  return std::nullopt;
}

/// Where another option draws level with the chosen one, and on which side of that it is ahead.
struct Crossing {
  double weight = 0.0;
  double way = 1.0;  ///< 1: above, -1: below
};

/// Nearest to `weight` first.
std::vector<Crossing> CrossingsFrom(double weight, std::string_view behavior, const HelmBids& bids,
                                    std::size_t chosen) {
  const MeritLine winner = LineOf(bids.options[chosen], behavior, bids.order);
  std::vector<Crossing> crossings;
  for (std::size_t i = 0; i < bids.options.size(); ++i) {
    if (i == chosen || VetoOn(bids.options[i]) != nullptr) {
      continue;
    }
    const MeritLine other = LineOf(bids.options[i], behavior, bids.order);
    const double gain = other.slope - winner.slope;
    const double level = (winner.at_zero - other.at_zero) / gain;
    if (gain != 0.0 && std::isfinite(level) && level >= 0.0) {
      crossings.push_back({.weight = level, .way = gain > 0.0 ? 1.0 : -1.0});
    }
  }
  std::ranges::stable_sort(
      crossings, {}, [weight](const Crossing& level) { return std::abs(level.weight - weight); });
  return crossings;
}

/// The first weight behind a crossing at which another option wins. At the crossing itself rounding
/// decides, so it steps out from a billionth of the weights.
std::optional<Flip> FlipBehind(const Crossing& crossing, const Flip& in_force, const HelmBids& bids,
                               std::size_t chosen) {
  constexpr double kFirstStep = 1e-9;
  constexpr int kSteps = 8;
  double step = kFirstStep * std::max({1.0, crossing.weight, in_force.weight});
  for (int i = 0; i < kSteps; ++i, step *= 4.0) {
    Flip flip = in_force;
    flip.new_weight = std::max(0.0, crossing.weight + crossing.way * step);
    const auto choice = ChoiceOf(Reweighted(bids, flip.behavior, flip.new_weight));
    if (choice && *choice != chosen) {
      flip.to = *choice;
      return flip;
    }
  }
  return std::nullopt;  // only level with it
}

}  // namespace

HelmBids Reweighted(const HelmBids& bids, std::string_view behavior, double weight) {
  HelmBids changed = bids;
  for (BiddenOption& option : changed.options) {
    for (OptionBid& bid : option.bids) {
      bid.weight = bid.behavior == behavior ? weight : bid.weight;
    }
    option.total = TotalOf(option.bids);
    option.rate = RateOf(option.total, option);
  }
  return changed;
}

std::optional<Flip> FlipOf(const HelmBids& bids, std::string_view behavior) {
  const std::optional<std::size_t> chosen = ChoiceOf(bids);
  const std::optional<double> weight = WeightOf(bids, behavior);
  if (!chosen || !weight) {
    return std::nullopt;
  }
  const Flip in_force{.behavior = std::string(behavior), .weight = *weight};
  for (const Crossing& crossing : CrossingsFrom(*weight, behavior, bids, *chosen)) {
    if (std::optional<Flip> flip = FlipBehind(crossing, in_force, bids, *chosen)) {
      return flip;
    }
  }
  return std::nullopt;
}

std::vector<std::string> BiddersOf(const HelmBids& bids) {
  std::vector<std::string> names;
  for (const BiddenOption& option : bids.options) {
    for (const OptionBid& bid : option.bids) {
      if (std::ranges::find(names, bid.behavior) == names.end()) {
        names.push_back(bid.behavior);
      }
    }
  }
  return names;
}

std::vector<Flip> FlipsOf(const HelmBids& bids) {
  std::vector<Flip> flips;
  for (const std::string& behavior : BiddersOf(bids)) {
    if (std::optional<Flip> flip = FlipOf(bids, behavior)) {
      flips.push_back(*std::move(flip));
    }
  }
  return flips;
}

}  // namespace limpet
