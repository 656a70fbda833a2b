// SPDX-License-Identifier: MIT
#include "limpet/explain/decision_log.hpp"

#include <algorithm>
#include <iterator>

namespace limpet {
namespace {

/// The last of `logged`, which is in order of time, until `time`; null before the first.
template <class Logged>
const Logged* LastUntil(double time, const std::vector<Logged>& logged) {
  const auto later = std::ranges::upper_bound(logged, time, {}, &Logged::time);
  return later == logged.begin() ? nullptr : &*std::prev(later);
}

/// False if `value` is none.
template <class Topic, class Logged>
bool Add(std::string_view value, double time, std::vector<Logged>& logged) {
  auto decoded = TopicCodec<Topic>::Decode(std::string(value));
  if (!decoded) {
    return false;
  }
  // A log's entries may be a little out of order: what was written before counts as before.
  const double last = logged.empty() ? time : logged.back().time;
  logged.push_back({std::max(time, last), *std::move(decoded)});
  return true;
}

}  // namespace

bool DecisionLog::Listens(std::string_view variable) {
  return variable == topics::kHelmBids.name || variable == topics::kHelmMotion.name;
}

void DecisionLog::Take(std::string_view variable, std::string_view value, double time) {
  bool is_read = true;
  if (variable == topics::kHelmBids.name) {
    is_read = Add<HelmBids>(value, time, decisions_);
  } else if (variable == topics::kHelmMotion.name) {
    is_read = Add<HelmMotion>(value, time, motions_);
  }
  unreadable_ += is_read ? 0 : 1;
}

const LoggedDecision* DecisionLog::InForceAt(double time) const {
  return LastUntil(time, decisions_);
}

const LoggedMotion* DecisionLog::MotionAt(double time) const { return LastUntil(time, motions_); }

}  // namespace limpet
