// SPDX-License-Identifier: MIT
#include "limpet/decision/merit.hpp"

#include <algorithm>

namespace limpet {
namespace {

constexpr double kShortestUnit = 1.0;  // [m]: an option of no length must not divide by zero

template <class Predicate>
const WeightedBid* FindBid(const BiddenOption& option, Predicate is_it) {
  const auto found = std::ranges::find_if(option.bids, is_it);
  return found == option.bids.end() ? nullptr : &*found;
}

}  // namespace

double TotalOf(std::span<const WeightedBid> bids) {
  double total = 0.0;
  for (const WeightedBid& bid : bids) {
    total += bid.Worth();
  }
  return total;
}

double RateLengthOf(const BiddenOption& option) {
  return std::max(option.rate_length.value_or(option.length), kShortestUnit);
}

double RateOf(double total, const BiddenOption& option) { return total / RateLengthOf(option); }

double MeritOf(const BiddenOption& option, OptionOrder order) {
  return order == OptionOrder::kPerMetre ? option.rate : option.total;
}

double ShareOf(const WeightedBid& bid, const BiddenOption& option, OptionOrder order) {
  const double part = bid.Worth();
  return order == OptionOrder::kPerMetre ? RateOf(part, option) : part;
}

const WeightedBid* VetoOn(const BiddenOption& option) {
  return FindBid(option, [](const WeightedBid& bid) { return bid.bid.veto.has_value(); });
}

const WeightedBid* BidOf(const BiddenOption& option, std::string_view behavior) {
  return FindBid(option, [behavior](const WeightedBid& bid) { return bid.behavior == behavior; });
}

bool IsBetter(const BiddenOption& a, const BiddenOption& b, OptionOrder order) {
  const bool is_a_vetoed = VetoOn(a) != nullptr;
  const bool is_b_vetoed = VetoOn(b) != nullptr;
  return is_a_vetoed != is_b_vetoed ? is_b_vetoed : MeritOf(a, order) > MeritOf(b, order);
}

std::optional<std::size_t> ChoiceOf(const HelmBids& bids) {
  std::optional<std::size_t> choice;
  for (std::size_t i = 0; i < bids.options.size(); ++i) {
    const BiddenOption& option = bids.options[i];
    if (VetoOn(option) == nullptr &&
        (!choice || IsBetter(option, bids.options[*choice], bids.order))) {
      choice = i;
    }
  }
  return choice;
}

}  // namespace limpet
