// SPDX-License-Identifier: MIT
#include "limpet/helm/view_decision.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limpet/decision/merit.hpp"

namespace limpet {
namespace {

struct ValuedOption {
  std::size_t index = 0;  ///< among those offered
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
  BiddenOption bidden;
  bidden.source = option.source;
  bidden.length = option.path.length();
  bidden.end = {end.north, end.east};
  for (const WeightedBehavior& running : behaviors) {
    const std::optional<Bid> bid = running.behavior->Value(prospect, now);
    if (!bid) {
      continue;
    }
    bidden.bids.push_back({.behavior = running.name,
                           .value = bid->value,
                           .weight = running.weight,
                           .has_veto = bid->veto.has_value(),
                           .why = WhyText(*bid)});
  }
  bidden.total = TotalOf(bidden.bids);
  bidden.rate = RateOf(bidden.total, bidden.length);
  return {.index = index, .bidden = std::move(bidden)};
}

}  // namespace

ViewDecision DecideView(std::span<const WeightedBehavior> behaviors, const Situation& now,
                        std::vector<Option> options, SeenAlong& seen, OptionOrder order) {
  std::vector<ValuedOption> valued;
  for (std::size_t i = 0; i < options.size(); ++i) {
    valued.push_back(ValueOption(behaviors, now, options[i], i, seen));
  }
  std::ranges::stable_sort(valued, [order](const ValuedOption& a, const ValuedOption& b) {
    return IsBetter(a.bidden, b.bidden, order);
  });
  ViewDecision decision;
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
