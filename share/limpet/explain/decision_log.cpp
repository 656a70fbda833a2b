// SPDX-License-Identifier: MIT
#include "limpet/explain/decision_log.hpp"

#include <algorithm>

namespace limpet {

bool DecisionLog::Listens(std::string_view variable) { return variable == topics::kHelmBids.name; }

void DecisionLog::Take(std::string_view variable, std::string_view value, double time) {
  if (!Listens(variable)) {
    return;
  }
  if (auto bids = TopicCodec<HelmBids>::Decode(std::string(value))) {
    decisions_.push_back({.time = time, .bids = *std::move(bids)});
  } else {
    ++unreadable_;
  }
}

const LoggedDecision* DecisionLog::InForceAt(double time) const {
  const auto later = std::ranges::find_if(
      decisions_, [time](const LoggedDecision& decision) { return decision.time > time; });
  return later == decisions_.begin() ? nullptr : &*std::prev(later);
}

}  // namespace limpet
