// SPDX-License-Identifier: MIT
#include "limpet/helm/view_decision.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace limpet {
namespace {

constexpr double kShortestUnit = 1.0;  // [m]: an option of no length must not divide by zero

struct ValuedOption {
  std::size_t index = 0;
  bool has_veto = false;
  BiddenOption bidden;
};

std::string WhyText(const Bid& bid) {
  if (bid.veto) {
    return *bid.veto;
  }
  std::string text;
  for (const Reason& reason : bid.why) {
    text += fmt::format("{}{}={:.2f}", text.empty() ? "" : " ", reason.name, reason.value);
  }
  return text;
}

ValuedOption ValueOption(std::span<const WeightedBehavior> behaviors, const Situation& now,
                         const Option& option, std::size_t index, SeenAlong& seen) {
  const Prospect prospect{.option = &option, .seen = seen(option.path)};
  const Pose2 end = option.path.end();
  ValuedOption valued{.index = index, .has_veto = false, .bidden = {}};
  valued.bidden.source = option.source;
  valued.bidden.length = option.path.length();
  valued.bidden.end = {end.north, end.east};
  for (const WeightedBehavior& running : behaviors) {
    const std::optional<Bid> bid = running.behavior->Value(prospect, now);
    if (!bid) {
      continue;
    }
    valued.has_veto = valued.has_veto || bid->veto.has_value();
    valued.bidden.total += running.weight * bid->value;
    valued.bidden.bids.push_back({.behavior = running.name,
                                  .value = bid->value,
                                  .weight = running.weight,
                                  .has_veto = bid->veto.has_value(),
                                  .why = WhyText(*bid)});
  }
  valued.bidden.rate = valued.bidden.total / std::max(valued.bidden.length, kShortestUnit);
  return valued;
}

}  // namespace

ViewDecision DecideView(std::span<const WeightedBehavior> behaviors, const Situation& now,
                        std::vector<Option> options, SeenAlong& seen, const DecisionRule& rule) {
  std::vector<ValuedOption> valued;
  for (std::size_t i = 0; i < options.size(); ++i) {
    valued.push_back(ValueOption(behaviors, now, options[i], i, seen));
  }
  const auto merit = [&rule](const ValuedOption& option) {
    return rule.order == OptionOrder::kPerMetre ? option.bidden.rate : option.bidden.total;
  };
  std::ranges::stable_sort(valued, [&merit](const ValuedOption& a, const ValuedOption& b) {
    return a.has_veto != b.has_veto ? b.has_veto : merit(a) > merit(b);
  });
  ViewDecision decision;
  decision.bids.considered = static_cast<int>(options.size());
  if (!valued.empty() && !valued.front().has_veto) {
    decision.chosen = std::move(options[valued.front().index]);
  }
  for (std::size_t i = 0; i < std::min(valued.size(), static_cast<std::size_t>(rule.listed)); ++i) {
    decision.bids.options.push_back(std::move(valued[i].bidden));
  }
  return decision;
}

}  // namespace limpet
