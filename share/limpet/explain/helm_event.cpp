// SPDX-License-Identifier: MIT
#include "limpet/explain/helm_event.hpp"

#include <algorithm>

#include "limpet/topics/viewer.hpp"

namespace limpet {
namespace {

/// The value of `key=value` in a list with commas; empty if it is not there.
std::string_view ValueOf(std::string_view key, std::string_view list) {
  while (!list.empty()) {
    std::string_view part = list.substr(0, list.find(','));
    list.remove_prefix(std::min(list.size(), part.size() + 1));
    part.remove_prefix(std::min(part.size(), part.find_first_not_of(' ')));
    if (part.starts_with(key) && part.substr(key.size()).starts_with('=')) {
      return part.substr(key.size() + 1);
    }
  }
  return {};
}

/// `1` for `1.00000`.
std::string_view WholePart(std::string_view number) { return number.substr(0, number.find('.')); }

}  // namespace

void HelmEvents::Add(HelmEvent::Kind kind, std::string_view who, std::string what) {
  events_.push_back(
      {.kind = kind, .time = last_, .who = std::string(who), .what = std::move(what)});
}

void HelmEvents::TakeLife(std::string_view value) {
  const std::string_view event = ValueOf("event", value);
  const std::string_view why = ValueOf("post_mortem", value);
  const std::string_view what = event == "spawn"   ? "began"
                                : event == "death" ? "ended"
                                : event == "abort" ? "could not begin"
                                                   : "";
  if (what.empty()) return;
  Add(HelmEvent::Kind::kLife, ValueOf("bname", value),
      std::string(what) + (why.empty() ? "" : ": " + std::string(why)));
}

void HelmEvents::Take(const LoggedWord& word, double time) {
  last_ = std::max(last_, time);  // a log's entries may be a little out of order
  if (word.variable == topics::kHelmLifeEvent.name) {
    TakeLife(word.value);
  } else if (word.writer == "HELM_MODE") {
    Add(HelmEvent::Kind::kMode, word.variable, "= " + std::string(word.value));
  } else if (word.variable == "WPT_INDEX" && !word.writer.empty()) {
    Add(HelmEvent::Kind::kWaypoint, word.writer,
        "on to waypoint " + std::string(WholePart(word.value)));
  } else if (word.variable == "WPT_STAT" && word.value.ends_with(",completed")) {
    Add(HelmEvent::Kind::kLife, ValueOf("behavior-name", word.value), "completed");
  }
}

std::span<const HelmEvent> HelmEvents::Between(double begin, double end) const {
  const auto from = std::ranges::upper_bound(events_, begin, {}, &HelmEvent::time);
  const auto to = std::ranges::upper_bound(events_, end, {}, &HelmEvent::time);
  if (to <= from) return {};
  return {from, to};
}

}  // namespace limpet
