// SPDX-License-Identifier: MIT
// planner_study [key=value ...]: the two-dimensional study of planners (docs/references.md),
// perfect pose.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "tests/bench/planner_study/study_run.hpp"
#include "tests/bench/planner_study/track_svg.hpp"

namespace limpet {
namespace {

struct Settings {
  StudyCase study;
  int runs = 10;
  int first_seed = 1;
  std::string svg;
};

/// Applies one key=value; false if there is no such key.
bool Apply(Settings& settings, const std::string& key, const std::string& text) {
  StudyCase& study = settings.study;
  const double number = std::strtod(text.c_str(), nullptr);
  const std::map<std::string, std::function<void()>> keys = {
      {"planner", [&] { study.planner = text; }},
      {"camera", [&] { study.camera = text; }},
      {"runs", [&] { settings.runs = static_cast<int>(number); }},
      {"seed", [&] { settings.first_seed = static_cast<int>(number); }},
      {"svg", [&] { settings.svg = text; }},
      {"fixed", [&] { study.has_fixed_start = number != 0.0; }},
      {"change", [&] { study.is_change = number != 0.0; }},
      {"band", [&] { study.area.object_height_max = number; }},
      {"margin", [&] { study.area.margin = number; }},
      {"execute", [&] { study.execute_m = number; }},
      {"path_max", [&] { study.path_max_m = number; }},
      {"top_stop", [&] { study.band_top_stop = number; }},
      {"target_value", [&] { study.target_value = number; }},
      {"w_cover", [&] { study.objective.ground.cover = number; }},
      {"w_frontier", [&] { study.objective.ground.frontier = number; }},
      {"bottom", [&] { study.bottom_weight = number; }},
      {"gap_below", [&] { study.gap_below = number; }},
      {"north", [&] { study.area.north_max = study.area.north_min + number; }},
      {"east", [&] { study.area.east_max = study.area.east_min + number; }},
      {"finish", [&] { study.gap.finish_share = number; }},
      {"late_share", [&] { study.late_share = number; }},
      {"late", [&] { study.late_frontier = number; }},
      {"decay", [&] { study.objective.target_decay_m = number; }},
      {"offers", [&] { study.beam.offers = static_cast<int>(number); }},
      {"width", [&] { study.beam.width = static_cast<int>(number); }},
      {"horizon", [&] { study.beam.horizon = Meters(number); }},
      {"primitive", [&] { study.beam.primitive = Meters(number); }},
      {"patches", [&] { study.gap.patches = static_cast<int>(number); }},
      {"tile", [&] { study.gap.tile = Meters(number); }},
      {"nodes", [&] { study.paper.nodes = static_cast<int>(number); }},
      {"edge", [&] { study.paper.max_edge = Meters(number); }},
      {"edits", [&] { study.plan.edits = static_cast<int>(number); }},
      {"first_edits", [&] { study.plan.first_edits = static_cast<int>(number); }},
      {"seeds", [&] { study.plan.seeds = static_cast<int>(number); }},
      {"warmth", [&] { study.plan.warmth = Meters(number); }},
      {"early", [&] { study.tour.early_weight = number; }},
      {"most", [&] { study.tour.most_weight = number; }},
      {"tour_finish", [&] { study.tour.finish_share = number; }},
      {"counts_band", [&] { study.paper_counts_band = number != 0.0; }},
  };
  const auto entry = keys.find(key);
  if (entry == keys.end()) {
    return false;
  }
  entry->second();
  return true;
}

/// Mean and standard deviation over the runs that got there.
struct Column {
  double sum = 0.0, squares = 0.0;
  int count = 0;
  void Add(const std::optional<double>& value) {
    if (value) {
      sum += *value, squares += *value * *value, ++count;
    }
  }
  [[nodiscard]] std::string Text(int runs) const {
    if (count == 0) {
      return "      -      ";
    }
    const double mean = sum / count;
    const double sd = std::sqrt(std::max(0.0, squares / count - mean * mean));
    const std::string missing = count < runs ? fmt::format(" ({}/{})", count, runs) : "";
    return fmt::format("{:5.0f} ± {:3.0f}{}", mean, sd, missing);
  }
};

int Run(const Settings& settings) {
  Column seabed90, seabed95, band95, band99, top975, whole, targets, ms_mean;
  double ms_max = 0.0;
  for (int run = 0; run < settings.runs; ++run) {
    const StudyResult result =
        RunStudy(settings.study, static_cast<std::uint64_t>(settings.first_seed + run));
    seabed90.Add(result.seabed90), seabed95.Add(result.seabed95);
    band95.Add(result.band95), band99.Add(result.band99);
    top975.Add(result.top975), whole.Add(result.whole), targets.Add(result.targets_seen);
    ms_mean.Add(result.plan_ms_mean);
    ms_max = std::max(ms_max, result.plan_ms_max);
    if (!settings.svg.empty() && run == 0) {
      WriteTrackSvg(settings.svg, settings.study, result);
    }
  }
  const int n = settings.runs;
  fmt::print(
      "seabed 90 {} | 95 {} | band 95 {} | 99 {} | top 97.5 {} | home {} | former {} | {:.1f} ms, "
      "max "
      "{:.1f}\n",
      seabed90.Text(n), seabed95.Text(n), band95.Text(n), band99.Text(n), top975.Text(n),
      whole.Text(n), targets.Text(n), ms_mean.sum / std::max(1, ms_mean.count), ms_max);
  return 0;
}

}  // namespace
}  // namespace limpet

int main(int argc, char** argv) {
  limpet::Settings settings;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const std::size_t equals = argument.find('=');
    if (equals == std::string::npos ||
        !limpet::Apply(settings, argument.substr(0, equals), argument.substr(equals + 1))) {
      fmt::print(stderr, "planner_study: unknown setting {}\n", argument);
      return 2;
    }
  }
  constexpr std::array<std::string_view, 4> kPlanners{"beam", "plan", "lanes", "paper"};
  if (std::ranges::find(kPlanners, std::string_view(settings.study.planner)) == kPlanners.end()) {
    fmt::print(stderr, "planner_study: no planner {}\n", settings.study.planner);
    return 2;
  }
  return limpet::Run(settings);
}
