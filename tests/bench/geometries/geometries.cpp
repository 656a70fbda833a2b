// SPDX-License-Identifier: MIT
// geometries LIMPET MISSIONS OUT [SEEDS]: areas of several shapes, each surveyed by our planner and
// along conventional lanes (`--planner lawnmower`) with the same seeds, by the command: whole way
// and time from start to home, and their ratios, as a table in Markdown. Flights that OUT already
// holds are not flown again.
//   LIMPET    the program, such as build/bin/limpet
//   MISSIONS  the folder of this file's missions, tests/bench/geometries; or any with others
//   SEEDS     how many, from 1 on (3)
#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limpet/core/number_text.hpp"
#include "limpet/sweeps/child_process.hpp"

namespace {

using namespace limpet;
namespace fs = std::filesystem;

/// A survey from start to home.
struct Flight {
  double way_m = 0.0, time_s = 0.0;
  double in_survey_m = 0.0;  ///< from the survey's start to where it comes up
  double band = 0.0;         ///< share of objects' places that was truly seen
  bool is_home = false;      ///< ended by its own judgement
  double reckoned_m = 0.0;   ///< best of all lanes, for what `in_survey_m` counts; 0: none
};

struct Runs {
  fs::path limpet, missions, out;
  int seeds = 3;
};

/// Flies what has not been flown; false if the command failed.
bool Fly(const Runs& runs, const std::string& name, const std::string& planner) {
  const fs::path out = runs.out / name / planner;
  fs::create_directories(out.parent_path());
  const ChildRun tables{
      .args = {"tables", (runs.missions / name).string(), "--sessions", "discovery", "--planner",
               planner, "--runs", std::to_string(runs.seeds), "--jobs", "1", "--set",
               "uSimCamera.camera=boxes", "--out", out.string()},
      .log = out.string() + ".log",
      .program = runs.limpet.string()};
  const int code = WaitForChild(StartChild(tables, SIGTERM));
  if (code == 0) return true;
  fmt::print(stderr, "{} of {}: exit code {}, see {}\n", planner, name, code, tables.log.string());
  return false;
}

Flight FlightOf(const Runs& runs, const std::string& name, const std::string& planner, int seed) {
  const fs::path file = runs.out / name / planner / std::to_string(seed) / "report.json";
  const auto session = nlohmann::json::parse(std::ifstream(file)).at("sessions").at("discovery");
  Flight flight{.way_m = session.at("path_m"),
                .time_s = session.at("duration_s"),
                .in_survey_m = session.at("survey_path_m"),
                .band = session.at("detected_band"),
                .is_home = session.at("ended") == "home"};
  if (const auto& lanes = session.at("lanes"); !lanes.is_null()) {
    flight.reckoned_m = lanes.at("path_m");
  }
  return flight;
}

/// Of the same seeds, the same number of them.
struct Pairs {
  std::vector<Flight> ours, lanes;
};

Pairs PairsOf(const Runs& runs, const std::string& name) {
  Pairs pairs;
  for (int seed = 1; seed <= runs.seeds; ++seed) {
    pairs.ours.push_back(FlightOf(runs, name, "limpet", seed));
    pairs.lanes.push_back(FlightOf(runs, name, "lawnmower", seed));
  }
  return pairs;
}

double MeanOf(const std::vector<Flight>& flights, double Flight::*what) {
  double sum = 0.0;
  for (const Flight& flight : flights)
    sum += flight.*what;
  return sum / static_cast<double>(flights.size());
}

double LeastBandOf(const std::vector<Flight>& flights) {
  return std::ranges::min(flights, {}, &Flight::band).band;
}

auto HomeOf(const std::vector<Flight>& flights) {
  return std::ranges::count_if(flights, &Flight::is_home);
}

/// "0.91 (0.95)": ratio of the means, and the worst of a seed.
std::string RatioText(const std::vector<double>& of, const std::vector<double>& to) {
  double sum_of = 0.0, sum_to = 0.0, worst = 0.0;
  for (std::size_t i = 0; i < of.size(); ++i) {
    sum_of += of[i], sum_to += to[i];
    worst = std::max(worst, of[i] / to[i]);
  }
  return fmt::format("{:.2f} ({:.2f})", sum_of / sum_to, worst);
}

std::vector<double> Each(const std::vector<Flight>& flights, double Flight::*what) {
  std::vector<double> values;
  for (const Flight& flight : flights)
    values.push_back(flight.*what);
  return values;
}

void PrintRow(const std::string& name, const Pairs& pairs) {
  const auto& [ours, lanes] = pairs;
  const bool are_reckoned =
      std::ranges::all_of(ours, [](const Flight& flight) { return flight.reckoned_m > 0.0; });
  fmt::print("| {} | {:.0f} | {:.0f} | {} | {:.2f} | {} | {:.3f} / {:.3f} | {} / {} |\n", name,
             MeanOf(ours, &Flight::way_m), MeanOf(lanes, &Flight::way_m),
             RatioText(Each(ours, &Flight::way_m), Each(lanes, &Flight::way_m)),
             MeanOf(ours, &Flight::time_s) / MeanOf(lanes, &Flight::time_s),
             are_reckoned
                 ? RatioText(Each(ours, &Flight::in_survey_m), Each(ours, &Flight::reckoned_m))
                 : "-",
             LeastBandOf(ours), LeastBandOf(lanes), HomeOf(ours), HomeOf(lanes));
}

int Run(const Runs& runs) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(runs.missions)) {
    if (fs::exists(entry.path() / "mission.moos")) names.push_back(entry.path().filename());
  }
  std::ranges::sort(names);
  fmt::print(
      "Means of {} seeds; ways from start to home.\n\n"
      "| area | ours [m] | lanes [m] | way (worst seed) | time | way against reckoned lanes (worst "
      "seed) | least band "
      "seen, ours / lanes | ended by own judgement |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |\n",
      runs.seeds);
  bool is_complete = !names.empty();
  for (const std::string& name : names) {
    if (!Fly(runs, name, "limpet") || !Fly(runs, name, "lawnmower")) {
      is_complete = false;
      continue;
    }
    PrintRow(name, PairsOf(runs, name));
  }
  return is_complete ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

int main(int argc, char** argv) {
  const std::optional<int> seeds = argc > 4 ? ParseInteger(argv[4]) : 3;
  if (argc < 4 || argc > 5 || seeds.value_or(0) < 1) {
    fmt::print(stderr, "usage: geometries LIMPET MISSIONS OUT [SEEDS, at least 1]\n");
    return 2;
  }
  const Runs runs{
      .limpet = fs::absolute(argv[1]), .missions = argv[2], .out = argv[3], .seeds = *seeds};
  try {
    return Run(runs);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return EXIT_FAILURE;
  }
}
