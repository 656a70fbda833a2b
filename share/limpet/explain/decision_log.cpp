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

HelmBids& Payload(LoggedDecision& logged) { return logged.bids; }
HelmMotion& Payload(LoggedMotion& logged) { return logged.motion; }

/// False if `value` is none.
template <class Topic, class Logged>
bool Add(std::string_view value, double time, std::vector<Logged>& logged) {
  auto decoded = TopicCodec<Topic>::Decode(std::string(value));
  if (!decoded) {
    return false;
  }
  // A log's entries may be a little out of order: what was written before counts as before.
  const double last = logged.empty() ? time : logged.back().time;
  Logged& added = logged.emplace_back();
  added.time = std::max(time, last);
  Payload(added) = *std::move(decoded);
  return true;
}

}  // namespace

void DecisionLog::Take(const LoggedWord& word, double time) {
  bool is_read = true;
  if (word.variable == topics::kHelmBids.name) {
    is_read = Add<HelmBids>(word.value, time, decisions_);
  } else if (word.variable == topics::kHelmMotion.name) {
    is_read = Add<HelmMotion>(word.value, time, motions_);
  } else {
    stops_.Take(word.variable, word.value, time);
    events_.Take(word, time);
    waiting_.Take(word.variable, word.value, time);
  }
  unreadable_ += is_read ? 0 : 1;
}

const LoggedDecision* DecisionLog::InForceAt(double time) const {
  return LastUntil(time, decisions_);
}

std::optional<LoggedMotion> DecisionLog::MotionAt(double time) const {
  if (const HelmStop* stop = stops_.At(time)) return MotionIn(*stop);
  const LoggedMotion* motion = LastUntil(time, motions_);
  if (motion == nullptr) return std::nullopt;
  // What it said last may be of before a stop that is over.
  const auto over = std::find_if(stops().rbegin(), stops().rend(), [&](const HelmStop& stop) {
    return stop.end && *stop.end <= time;
  });
  const bool is_stale = over != stops().rend() && motion->time < *over->end - kIteration;
  return is_stale ? MotionAfter(*over) : *motion;
}

LoggedMotion DecisionLog::MotionIn(const HelmStop& stop) const {
  LoggedMotion stopped{.time = stop.begin, .motion = {}, .stopped = stop.why};
  const LoggedMotion* wanted = LastUntil(stop.begin + kIteration, motions_);
  if (wanted != nullptr && wanted->time >= stop.begin - kIteration) {
    stopped.motion.opinions = wanted->motion.opinions;
  }
  return stopped;
}

LoggedMotion DecisionLog::MotionAfter(const HelmStop& stop) const {
  const double end = stop.end.value_or(stop.begin);
  const auto first = std::ranges::lower_bound(motions_, end - kIteration, {}, &LoggedMotion::time);
  const bool is_in_next = first != motions_.end() && stops_.At(first->time) != nullptr &&
                          stops_.At(first->time)->begin >= end;
  if (first == motions_.end() || is_in_next) return {.time = end, .motion = {}, .stopped = {}};
  return *first;
}

}  // namespace limpet
