// SPDX-License-Identifier: MIT
// How far `limpet why` agrees with what was flown: of each decision in the logs below some folders,
// whether the table adds up to the totals that the helm wrote, whether the choice by that table is
// the path that the helm flew, and whether each weight named as one that flips it does, when the
// decision is made again with it.
//
//   why_agreement RUNS...   folders of runs; exit code 1 if anything disagrees
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "limpet/decision/merit.hpp"
#include "limpet/explain/explanation.hpp"
#include "limpet/logbook/alog_reader.hpp"
#include "limpet/logbook/logs_below.hpp"

namespace limpet {
namespace {

struct Agreement {
  int logs = 0, decisions = 0, flown = 0, flips = 0;
  int wrong_totals = 0, wrong_choices = 0, wrong_flips = 0;

  [[nodiscard]] bool IsWhole() const {
    return decisions > 0 && wrong_totals + wrong_choices + wrong_flips == 0;
  }
};

bool AddsUp(const BiddenOption& option) {
  return option.total == TotalOf(option.bids) && option.rate == RateOf(option.total, option);
}

bool IsFlown(const BiddenOption& option, const HelmPath& path) {
  double length = 0.0;
  for (const PathSegment& segment : path.segments)
    length += segment.length;
  return option.source == path.purpose && std::abs(option.length - length) < 1e-9;
}

/// Decides again with the other weight; what wins must be ahead by more than rounding.
bool Flips(const Flip& flip, const HelmBids& bids, std::size_t chosen) {
  constexpr double kRounding = 1e-10;  // part of what either is worth
  const HelmBids changed = Reweighted(bids, flip.behavior, flip.new_weight);
  if (ChoiceOf(changed) != flip.to || flip.to == chosen) return false;
  const double won = MeritOf(changed.options[flip.to], bids.order);
  const double lost = MeritOf(changed.options[chosen], bids.order);
  return won - lost > kRounding * std::max(std::abs(won), std::abs(lost));
}

/// `path`: flown upon it; nothing if the helm wrote none before its next decision.
void Judge(const HelmBids& bids, const std::optional<HelmPath>& path, Agreement& all) {
  ++all.decisions;
  for (const BiddenOption& option : bids.options)
    all.wrong_totals += AddsUp(option) ? 0 : 1;
  const Explanation explanation = Explain({.time = 0.0, .bids = bids});
  const bool is_chosen = explanation.chosen.has_value();
  all.flown += path ? 1 : 0;
  if (is_chosen != path.has_value() ||
      (path && !IsFlown(bids.options[*explanation.chosen], *path))) {
    ++all.wrong_choices;
  }
  for (const Flip& flip : explanation.flips) {
    ++all.flips;
    all.wrong_flips += Flips(flip, bids, *explanation.chosen) ? 0 : 1;
  }
}

void JudgeLog(const std::filesystem::path& log, Agreement& all) {
  auto reader = AlogReader::Open(log);
  if (!reader) {
    fmt::print(stderr, "why_agreement: {}: cannot be read\n", log.string());
    return;
  }
  ++all.logs;
  std::optional<HelmBids> bids;
  std::optional<HelmPath> path;
  const auto judge = [&] {
    if (bids) Judge(*bids, path, all);
    bids.reset(), path.reset();
  };
  AlogEntry entry;
  while (reader->Next(entry)) {
    if (entry.name == topics::kHelmBids.name) {
      judge();
      if (auto read = TopicCodec<HelmBids>::Decode(std::string(entry.value))) bids = *read;
    } else if (entry.name == topics::kHelmPath.name && bids) {
      auto read = TopicCodec<HelmPath>::Decode(std::string(entry.value));
      if (read && read->id == bids->path_id) path = *read;
    }
  }
  judge();
}

}  // namespace

int Run(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "why_agreement RUNS...: folders of runs\n");
    return 2;
  }
  Agreement all;
  for (int i = 1; i < argc; ++i) {
    for (const std::filesystem::path& log : LogsBelow(argv[i]))
      JudgeLog(log, all);
  }
  fmt::print("{} folders, {} logs, {} decisions, {} paths flown upon them, {} flips named\n",
             argc - 1, all.logs, all.decisions, all.flown, all.flips);
  fmt::print("do not agree: {} totals, {} choices, {} flips\n", all.wrong_totals, all.wrong_choices,
             all.wrong_flips);
  return all.IsWhole() ? 0 : 1;
}

}  // namespace limpet

int main(int argc, char** argv) { return limpet::Run(argc, argv); }
