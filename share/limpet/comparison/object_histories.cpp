// SPDX-License-Identifier: MIT
#include "limpet/comparison/object_histories.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limpet/comparison/comparison_json.hpp"
#include "limpet/core/require.hpp"

namespace limpet {
namespace {

using OrderedJson = nlohmann::ordered_json;

bool IsThere(const OpiBelief& object) { return object.landmark.has_value(); }

/// How sure it is whether an object that is there was there before.
double Surest(const OpiBelief& object) {
  return std::max(object.posterior.confirmed, object.posterior.appeared);
}

/// Follows objects from session to session.
class HistoryKeeper {
 public:
  HistoryKeeper(const std::vector<SavedSession>& sessions, std::optional<std::string> mission)
      : sessions_(sessions), mission_(std::move(mission)) {}

  SessionSeries Tell() {
    for (const SavedSession& session : sessions_)
      series_.sessions.push_back(session.facts);
    BeginWithFirst();
    for (std::size_t now = 1; now < sessions_.size(); ++now)
      Step(now);
    return std::move(series_);
  }

 private:
  /// The comparison of two sessions, made once and kept.
  const SessionComparison& Between(std::size_t former, std::size_t now) {
    const auto known = comparisons_.find({former, now});
    if (known != comparisons_.end()) return known->second;
    return comparisons_
        .emplace(std::pair(former, now),
                 CompareSessions(sessions_[former], sessions_[now], mission_))
        .first->second;
  }

  void BeginWithFirst() {
    for (const FormerObject& object :
         PriorOf(sessions_.front().facts, sessions_.front().memory).former.objects) {
      series_.objects.push_back(
          {.color = object.object.color,
           .p_W = object.object.p_W,
           .entries = {{.decided = Status::kNew, .posterior = std::nullopt, .id = object.id}}});
    }
  }

  /// The id that a session itself has for a landmark of its own; nothing: it has none.
  [[nodiscard]] std::optional<int> IdOf(std::size_t session,
                                        const std::optional<int>& landmark) const {
    const std::vector<OpiBelief>& own = sessions_[session].memory.objects.opis;
    const auto found = std::ranges::find(own, landmark, &OpiBelief::landmark);
    return landmark && found != own.end() ? std::optional(found->id) : std::nullopt;
  }

  void Step(std::size_t now) {
    series_.steps.push_back(Between(now - 1, now));
    std::vector<int> taken;  // landmarks of this session that have a history
    // Objects of the session before come first: what it knows of them is fresher.
    for (const bool is_gone : {false, true}) {
      for (ObjectHistory& object : series_.objects) {
        const bool is_told = object.since + object.entries.size() > now;
        const bool was_there = object.placed_in + 1 == now;
        if (!is_told && was_there != is_gone) Follow(object, now, taken);
      }
    }
    for (const OpiBelief& object : Between(now - 1, now).objects) {
      const bool is_known = std::ranges::find(taken, object.landmark) != taken.end();
      if (object.former_id || !IsThere(object) || is_known) continue;
      series_.objects.push_back({.color = object.object.color,
                                 .p_W = object.object.p_W,
                                 .placed_in = now,
                                 .since = now,
                                 .entries = {EntryOfNewcomer(object, now)}});
    }
  }

  /// As the last session judges it that knows what was there before: one that looked elsewhere
  /// leaves it open. If all do, as the one that says most. One that had another object there says
  /// nothing of this one.
  [[nodiscard]] HistoryEntry EntryOfNewcomer(const OpiBelief& object, std::size_t now) {
    const OpiBelief* best = &object;
    std::size_t by = now - 1;
    for (std::size_t former = now - 1; IsOpen(best->decided) && former-- > 0;) {
      const std::vector<OpiBelief>& said = Between(former, now).objects;
      const auto found = std::ranges::find(said, object.landmark, &OpiBelief::landmark);
      if (found == said.end() || found->former_id) continue;
      if (!IsOpen(found->decided) || Surest(*found) > Surest(*best)) best = &*found, by = former;
    }
    return EntryOf(*best, by, now);
  }

  /// What session `now` says of an object, judged by session `former`.
  [[nodiscard]] HistoryEntry EntryOf(const OpiBelief& object, std::size_t former,
                                     std::size_t now) const {
    return {.decided = object.decided,
            .posterior = object.posterior,
            .id = IdOf(now, object.landmark),
            .judged_by = former};
  }

  /// Adds what session `now` says of an object, by comparing it with the last session that had it.
  void Follow(ObjectHistory& object, std::size_t now, std::vector<int>& taken) {
    const std::vector<OpiBelief>& said = Between(object.placed_in, now).objects;
    const std::optional<int> id = object.entries[object.placed_in - object.since].id;
    const auto found = std::ranges::find_if(said, [&](const OpiBelief& one) {
      return one.former_id == id && std::ranges::find(taken, one.landmark) == taken.end();
    });
    if (found == said.end()) {
      // It was hardly one when it was last seen, or what stands there is another object's.
      object.entries.push_back({.decided = Status::kUncertain, .judged_by = object.placed_in});
      return;
    }
    HistoryEntry entry = EntryOf(*found, object.placed_in, now);
    const bool was_gone = std::ranges::any_of(
        object.entries.begin() + static_cast<std::ptrdiff_t>(object.placed_in - object.since),
        object.entries.end(),
        [](const HistoryEntry& before) { return before.decided == Status::kRemoved; });
    entry.is_back = IsThere(*found) && was_gone;
    object.entries.push_back(entry);
    if (!IsThere(*found)) return;
    taken.push_back(*found->landmark);
    object.p_W = found->object.p_W;
    object.placed_in = now;
  }

  const std::vector<SavedSession>& sessions_;
  std::optional<std::string> mission_;
  std::map<std::pair<std::size_t, std::size_t>, SessionComparison> comparisons_;
  SessionSeries series_;
};

OrderedJson EntryJson(const HistoryEntry& entry, std::size_t session) {
  return {{"session", session + 1},
          {"decided", NameOf(entry.decided)},
          {"back", entry.is_back},
          {"id", entry.id ? OrderedJson(*entry.id) : OrderedJson(nullptr)},
          {"judged_by", entry.judged_by ? OrderedJson(*entry.judged_by + 1) : OrderedJson(nullptr)},
          {"posterior", entry.posterior ? JsonOf(*entry.posterior) : OrderedJson(nullptr)}};
}

OrderedJson HistoryJson(const ObjectHistory& object) {
  OrderedJson entries = OrderedJson::array();
  for (std::size_t i = 0; i < object.entries.size(); ++i)
    entries.push_back(EntryJson(object.entries[i], object.since + i));
  return {{"color", object.color},
          {"ned_m", {object.p_W.x(), object.p_W.y(), object.p_W.z()}},
          {"placed_in", object.placed_in + 1},
          {"story", StoryOf(object)},
          {"entries", std::move(entries)}};
}

}  // namespace

SessionSeries CompareSeries(const std::vector<SavedSession>& sessions,
                            const std::optional<std::string>& mission) {
  LIMPET_REQUIRE(sessions.size() >= 2, "one session has nothing to be compared with");
  return HistoryKeeper(sessions, mission).Tell();
}

std::string StoryOf(const ObjectHistory& object) {
  std::string story = fmt::format("seen in {}", object.since + 1);
  for (std::size_t i = 1; i < object.entries.size(); ++i) {
    const HistoryEntry& entry = object.entries[i];
    const std::string what = entry.is_back && entry.decided == Status::kConfirmed
                                 ? "back"
                                 : std::string(NameOf(entry.decided));
    story += fmt::format(", {} in {}", what, object.since + i + 1);
  }
  return story;
}

std::string Json(const SessionSeries& series) {
  OrderedJson out = JsonOf(series.steps.back());
  OrderedJson sessions = OrderedJson::array(), steps = OrderedJson::array(),
              objects = OrderedJson::array();
  for (const SessionFacts& facts : series.sessions)
    sessions.push_back(JsonOf(facts));
  for (const SessionComparison& step : series.steps)
    steps.push_back(JsonOf(step));
  for (const ObjectHistory& object : series.objects)
    objects.push_back(HistoryJson(object));
  out["changes_of"] = {series.sessions.size() - 1, series.sessions.size()};
  out["sessions"] = std::move(sessions);
  out["steps"] = std::move(steps);
  out["objects"] = std::move(objects);
  return out.dump(1) + "\n";
}

}  // namespace limpet
