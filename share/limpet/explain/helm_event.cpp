// SPDX-License-Identifier: MIT
#include "limpet/explain/helm_event.hpp"

#include <algorithm>

#include "limpet/core/record.hpp"
#include "limpet/topics/viewer.hpp"

namespace limpet {
namespace {

/// A field of text `name=value,...`; empty if it is not there.
std::string FieldOf(const char* name, std::string_view text) {
  std::string field;
  RecordReader fields(text);
  fields(name, field);
  return field;
}

/// `1` for `1.00000`.
std::string_view WholePart(std::string_view number) { return number.substr(0, number.find('.')); }

}  // namespace

void HelmEvents::Add(HelmEvent::Kind kind, std::string_view who, std::string what) {
  events_.push_back(
      {.kind = kind, .time = last_, .who = std::string(who), .what = std::move(what)});
}

void HelmEvents::TakeLife(std::string_view value) {
  const std::string event = FieldOf("event", value);
  const std::string why = FieldOf("post_mortem", value);
  const std::string_view what = event == "spawn"   ? "began"
                                : event == "death" ? "ended"
                                : event == "abort" ? "could not begin"
                                                   : "";
  if (what.empty()) return;
  Add(HelmEvent::Kind::kLife, FieldOf("bname", value),
      std::string(what) + (why.empty() ? "" : ": " + why));
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
    Add(HelmEvent::Kind::kLife, FieldOf("behavior-name", word.value), "completed");
  }
}

std::span<const HelmEvent> HelmEvents::Between(const Interval& span) const {
  const auto from = std::ranges::upper_bound(events_, span.low, {}, &HelmEvent::time);
  const auto to = std::ranges::upper_bound(events_, span.high, {}, &HelmEvent::time);
  if (to <= from) return {};
  return {from, to};
}

}  // namespace limpet
