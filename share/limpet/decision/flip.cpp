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
  for (const WeightedBid& bid : option.bids) {
    if (bid.behavior == behavior) {
      WeightedBid of_weight_1 = bid;
      of_weight_1.weight = 1.0;
      line.slope += ShareOf(of_weight_1, option, order);
    } else {
      line.at_zero += ShareOf(bid, option, order);
    }
  }
  return line;
}

/// Part of two options' merits below which their difference is rounding.
constexpr double kRounding = 1e-9;

/// How two options compare over the weight of one behavior.
struct Comparison {
  double lead = 0.0;  ///< of the chosen one at weight 0
  double gain = 0.0;  ///< of the other one with each unit of weight
};

/// Differences that are rounding are none: options that are worth the same are one.
Comparison Compare(const MeritLine& chosen, const MeritLine& other, double weight) {
  const double unit = std::max(1.0, weight);
  const double scale = std::max(std::abs(chosen.at_zero), std::abs(other.at_zero)) +
                       std::max(std::abs(chosen.slope), std::abs(other.slope)) * unit;
  const auto rounded = [scale](double difference, double times) {
    return std::abs(difference) * times > kRounding * scale ? difference : 0.0;
  };
  return {.lead = rounded(chosen.at_zero - other.at_zero, 1.0),
          .gain = rounded(other.slope - chosen.slope, unit)};
}

std::optional<double> WeightOf(const HelmBids& bids, std::string_view behavior) {
  for (const BiddenOption& option : bids.options) {
    if (const WeightedBid* bid = BidOf(option, behavior)) {
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
    const Comparison with = Compare(winner, LineOf(bids.options[i], behavior, bids.order), weight);
    const double level = with.lead / with.gain;
    if (with.gain != 0.0 && std::isfinite(level) && level >= 0.0) {
      crossings.push_back({.weight = level, .way = with.gain > 0.0 ? 1.0 : -1.0});
    }
  }
  std::ranges::stable_sort(
      crossings, {}, [weight](const Crossing& level) { return std::abs(level.weight - weight); });
  return crossings;
}

/// True if two options are worth the same whatever the behavior's weight.
bool IsSameWorth(const HelmBids& bids, std::size_t a, std::size_t b, const Flip& flip) {
  const auto line = [&](std::size_t option) {
    return LineOf(bids.options[option], flip.behavior, bids.order);
  };
  const Comparison with = Compare(line(a), line(b), flip.weight);
  return with.lead == 0.0 && with.gain == 0.0;
}

/// How large the parts of an option's merit are: what its rounding goes with.
double PartsOf(const BiddenOption& option, OptionOrder order) {
  double parts = 0.0;
  for (const WeightedBid& bid : option.bids)
    parts += std::abs(ShareOf(bid, option, order));
  return parts;
}

/// True if `a` is worth more than `b` by more than rounding could make it.
bool IsClearlyBetter(const BiddenOption& a, const BiddenOption& b, OptionOrder order) {
  const double scale = std::max(PartsOf(a, order), PartsOf(b, order));
  return MeritOf(a, order) - MeritOf(b, order) > kRounding * scale;
}

/// The first weight behind a crossing at which an option that differs wins, and clearly. At the
/// crossing itself rounding decides, so it steps out from a billionth of the weights.
std::optional<Flip> FlipBehind(const Crossing& crossing, const Flip& in_force, const HelmBids& bids,
                               std::size_t chosen) {
  constexpr double kFirstStep = 1e-9;
  constexpr int kSteps = 15;  // the last one is a quarter of the weights
  double step = kFirstStep * std::max({1.0, crossing.weight, in_force.weight});
  for (int i = 0; i < kSteps; ++i, step *= 4.0) {
    Flip flip = in_force;
    flip.new_weight = std::max(0.0, crossing.weight + crossing.way * step);
    const HelmBids changed = Reweighted(bids, flip.behavior, flip.new_weight);
    const auto choice = ChoiceOf(changed);
    if (choice && *choice != chosen && !IsSameWorth(bids, chosen, *choice, in_force) &&
        IsClearlyBetter(changed.options[*choice], changed.options[chosen], bids.order)) {
      flip.to = *choice;
      return flip;
    }
    if (flip.new_weight == 0.0) break;  // no weight is less
  }
  return std::nullopt;  // only level with it
}

}  // namespace

HelmBids Reweighted(const HelmBids& bids, std::string_view behavior, double weight) {
  HelmBids changed = bids;
  for (BiddenOption& option : changed.options) {
    for (WeightedBid& bid : option.bids) {
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
    for (const WeightedBid& bid : option.bids) {
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
