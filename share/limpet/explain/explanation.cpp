// SPDX-License-Identifier: MIT
#include "limpet/explain/explanation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "limpet/decision/merit.hpp"

namespace limpet {
namespace {

const char* UnitOfBids(OptionOrder order) {
  return order == OptionOrder::kPerMetre ? " per metre" : " in total";
}

/// What a behavior gives the winner and not another option.
struct Deficit {
  std::string behavior;
  double value = 0.0;
};

/// What each behavior holds against `option` beside `winner`, the most first.
std::vector<Deficit> DeficitsOf(const BiddenOption& option, const BiddenOption& winner,
                                const std::vector<std::string>& bidders, OptionOrder order) {
  const auto share = [order](const BiddenOption& of, const std::string& behavior) {
    const WeightedBid* bid = BidOf(of, behavior);
    return bid == nullptr ? 0.0 : ShareOf(*bid, of, order);
  };
  std::vector<Deficit> deficits;
  for (const std::string& behavior : bidders) {
    deficits.push_back({behavior, share(winner, behavior) - share(option, behavior)});
  }
  std::ranges::stable_sort(deficits, std::ranges::greater{}, &Deficit::value);
  return deficits;
}

std::string WhyLost(const BiddenOption& option, const HelmBids& bids, std::size_t chosen,
                    const std::vector<std::string>& bidders) {
  const BiddenOption& winner = bids.options[chosen];
  const double behind = MeritOf(winner, bids.order) - MeritOf(option, bids.order);
  if (behind <= 0.0) {
    return "worth the same, and offered later";
  }
  const Deficit most = DeficitsOf(option, winner, bidders, bids.order).front();
  const bool is_all_of_it = std::abs(most.value - behind) < 0.005 * behind;
  return fmt::format("{:.3g} less{}, {} {}", behind, UnitOfBids(bids.order),
                     is_all_of_it ? "by" : "most by", most.behavior);
}

}  // namespace

Explanation Explain(const LoggedDecision& decision, std::optional<LoggedMotion> motion) {
  const HelmBids& bids = decision.bids;
  Explanation explanation{.time = decision.time,
                          .path_id = bids.path_id,
                          .cause = bids.cause,
                          .order = bids.order,
                          .chosen = ChoiceOf(bids),
                          .options = {},
                          .bidders = BiddersOf(bids),
                          .flips = FlipsOf(bids),
                          .motion = std::move(motion)};
  for (std::size_t i = 0; i < bids.options.size(); ++i) {
    ExplainedOption option{.bidden = bids.options[i], .lost_because = {}};
    if (const WeightedBid* veto = VetoOn(option.bidden)) {
      option.lost_because = fmt::format("vetoed by {}: {}", veto->behavior, WhyText(veto->bid));
    } else if (explanation.chosen && i != *explanation.chosen) {
      option.lost_because = WhyLost(option.bidden, bids, *explanation.chosen, explanation.bidders);
    }
    explanation.options.push_back(std::move(option));
  }
  return explanation;
}

std::string SummaryOf(const Explanation& explanation) {
  if (!explanation.chosen) {
    return fmt::format("nothing, of {} options", explanation.options.size());
  }
  const BiddenOption& chosen = explanation.options[*explanation.chosen].bidden;
  return fmt::format("{}, {:.1f} m, {:.3g} per metre, of {} options", chosen.source, chosen.length,
                     chosen.rate, explanation.options.size());
}

}  // namespace limpet
