// SPDX-License-Identifier: MIT
#include "limpet/explain/motion_explanation.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "limpet/explain/motion_difference.hpp"

namespace limpet {
namespace {

/// In a list with commas.
void AddTo(const std::string& text, std::string& all) {
  if (!text.empty()) all += (all.empty() ? "" : ", ") + text;
}

/// What befell modes and behaviors; of each the weightiest only: who has completed begins anew with
/// its first waypoint.
std::string EventsText(std::span<const HelmEvent> events) {
  std::vector<HelmEvent> sorted(events.begin(), events.end());
  std::ranges::stable_sort(sorted, {}, &HelmEvent::kind);
  std::string text;
  for (auto event = sorted.begin(); event != sorted.end(); ++event) {
    const auto same = [&](const HelmEvent& other) { return other.who == event->who; };
    if (event->kind != HelmEvent::Kind::kMode && std::any_of(sorted.begin(), event, same)) continue;
    AddTo(fmt::format("{}{} {}", event->who, event->kind == HelmEvent::Kind::kWaypoint ? ":" : "",
                      event->what),
          text);
  }
  return text;
}

std::vector<HelmEvent> ModesIn(std::span<const HelmEvent> events) {
  std::vector<HelmEvent> modes;
  std::ranges::copy_if(events, std::back_inserter(modes),
                       [](const HelmEvent& event) { return event.kind == HelmEvent::Kind::kMode; });
  return modes;
}

/// Goes through the words of the helm on how it moves.
class ChangeFinder {
 public:
  explicit ChangeFinder(const DecisionLog& log) : log_(log) {}

  /// The change at `now`, if it is one.
  std::optional<MotionChange> Next(const LoggedMotion& now) {
    const std::span<const HelmEvent> events =
        log_.events().Between({heard_until_, now.time + DecisionLog::kIteration});
    heard_until_ = now.time + DecisionLog::kIteration;
    const std::string difference = last_ ? DifferenceBetween(last_->motion, now.motion) : "";
    if (last_ && difference.empty() && ModesIn(events).empty()) return std::nullopt;
    MotionChange change{.time = now.time, .cause = "", .motion = now};
    // As the helm begins it makes all its behaviors: that is no cause.
    if (last_) {
      change.cause = EventsText(events);
      if (change.cause.empty()) change.cause = difference;
    } else {
      change.cause = "the helm's first word";
    }
    last_ = now;
    return change;
  }
  /// A stop is over, which is a change by itself.
  MotionChange After(MotionChange stop) {
    AddTo(EventsText(
              ModesIn(log_.events().Between({stop.time - DecisionLog::kIteration, stop.time}))),
          stop.cause);
    heard_until_ = std::max(heard_until_, stop.time);
    last_ = stop.motion;
    return stop;
  }

 private:
  const DecisionLog& log_;
  std::optional<LoggedMotion> last_;
  double heard_until_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

Explanation ExplainMotion(const LoggedMotion& logged) {
  Explanation explanation;
  explanation.time = logged.time;
  explanation.cause = "no behavior decides where next";
  explanation.motion = logged;
  return explanation;
}

Explanation ExplainChange(const MotionChange& change) {
  Explanation explanation = ExplainMotion(change.motion);
  explanation.time = change.time;
  explanation.cause = change.cause;
  return explanation;
}

std::vector<MotionChange> StopsOf(const DecisionLog& log) {
  std::vector<MotionChange> changes;
  const std::vector<HelmStop>& stops = log.stops();
  for (auto stop = stops.begin(); stop != stops.end(); ++stop) {
    changes.push_back(
        {.time = stop->begin, .cause = "stopped: " + stop->why, .motion = log.MotionIn(*stop)});
    const bool is_another_next =
        std::next(stop) != stops.end() && std::next(stop)->begin == stop->end;
    if (stop->end && !is_another_next) {
      changes.push_back({.time = *stop->end,
                         .cause = "goes on after " + stop->why,
                         .motion = log.MotionAfter(*stop)});
    }
  }
  return changes;
}

std::vector<MotionChange> ChangesOfMotion(const DecisionLog& log) {
  const std::vector<MotionChange> stops = StopsOf(log);
  std::vector<MotionChange> changes;
  ChangeFinder finder(log);
  auto stop = stops.begin();
  const auto take_stops_until = [&](double time) {
    for (; stop != stops.end() && stop->time <= time; ++stop) {
      changes.push_back(stop->motion.stopped ? *stop : finder.After(*stop));
    }
  };
  for (const LoggedMotion& now : log.motions()) {
    // The helm says how it would move first, and in the same iteration that it stops or goes on.
    take_stops_until(now.time + DecisionLog::kIteration);
    const bool is_stopped = !changes.empty() && changes.back().motion.stopped.has_value();
    if (is_stopped) continue;
    if (std::optional<MotionChange> change = finder.Next(now))
      changes.push_back(*std::move(change));
  }
  take_stops_until(std::numeric_limits<double>::infinity());
  return changes;
}

}  // namespace limpet
