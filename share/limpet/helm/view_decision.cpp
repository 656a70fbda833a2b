// SPDX-License-Identifier: MIT
#include "limpet/helm/view_decision.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "limpet/decision/merit.hpp"
#include "limpet/helm/behavior_failure_warnings.hpp"

namespace limpet {
namespace {

struct ValuedOption {
  std::size_t index = 0;  ///< among those offered
  BiddenOption bidden;
};

/// What a behavior bids on every option; or why it is not heard.
struct Valuation {
  std::vector<std::optional<Bid>> bids;
  std::optional<BehaviorFailure> failure;
  std::optional<std::string> late;
};

Valuation ValuationBy(const WeightedBehavior& running, const Situation& now,
                      std::span<const Prospect> prospects, AnswerWatch& watch) {
  Valuation valuation;
  valuation.failure = FailureOf(running.name, [&] {
    valuation.late = watch.AskEach(running.name, prospects.size(), [&](std::size_t i) {
      valuation.bids.push_back(running.behavior->Value(prospects[i], now));
      if (const auto& bid = valuation.bids.back(); bid && !std::isfinite(bid->value)) {
        throw std::domain_error("NaN or infinity as the worth of an option");
      }
    });
  });
  return valuation;
}

ValuedOption Unvalued(const Option& option, std::size_t index) {
  const Pose2 end = option.path.end();
  ValuedOption valued{.index = index, .bidden = {}};
  valued.bidden.source = option.source;
  valued.bidden.length = option.path.length();
  valued.bidden.end = {end.north, end.east};
  return valued;
}

/// All wholes lead to the end of the survey: per metre of its own, a long way to it would seem the
/// less bad.
std::optional<double> ShortestWhole(const std::vector<Option>& options) {
  std::optional<double> shortest;
  for (const Option& option : options) {
    if (!option.is_whole()) continue;
    shortest = std::min(shortest.value_or(option.path.length()), option.path.length());
  }
  return shortest;
}

}  // namespace

ViewDecision DecideView(std::span<const WeightedBehavior> behaviors, const Situation& now,
                        std::vector<Option> options, SeenAlong& seen, OptionOrder order,
                        AnswerWatch* watch) {
  std::vector<ValuedOption> valued;
  std::vector<Prospect> prospects;
  for (const Option& option : options) {
    prospects.emplace_back(option, seen(option.path));
    valued.push_back(Unvalued(option, valued.size()));
  }
  ViewDecision decision;
  AnswerWatch nobody_is_late{{}};
  const std::optional<double> shortest_whole = ShortestWhole(options);
  for (const WeightedBehavior& running : behaviors) {
    Valuation valuation =
        ValuationBy(running, now, prospects, watch != nullptr ? *watch : nobody_is_late);
    if (valuation.late) decision.late.push_back(LatenessOf(running.name, *valuation.late));
    if (valuation.late) continue;
    if (valuation.failure) {
      decision.failures.push_back(*valuation.failure);
      continue;
    }
    for (std::size_t i = 0; i < options.size(); ++i) {
      if (std::optional<Bid>& bid = valuation.bids[i]) {
        valued[i].bidden.bids.push_back(
            {.behavior = running.name, .weight = running.weight, .bid = *std::move(bid)});
      }
    }
  }
  for (ValuedOption& option : valued) {
    if (options[option.index].is_whole()) option.bidden.rate_length = shortest_whole;
    option.bidden.total = TotalOf(option.bidden.bids);
    option.bidden.rate = RateOf(option.bidden.total, option.bidden);
  }
  std::ranges::stable_sort(valued, [order](const ValuedOption& a, const ValuedOption& b) {
    return IsBetter(a.bidden, b.bidden, order);
  });
  decision.bids.considered = static_cast<int>(options.size());
  decision.bids.order = order;
  for (ValuedOption& option : valued) {
    decision.bids.options.push_back(std::move(option.bidden));
  }
  if (const std::optional<std::size_t> chosen = ChoiceOf(decision.bids)) {
    decision.chosen = std::move(options[valued[*chosen].index]);
  }
  return decision;
}

}  // namespace limpet
