// SPDX-License-Identifier: MIT
// How does a survey go on a site that nobody has tuned it on? Sessions over areas drawn at random,
// flown in closed loop by the command itself.
//   drawn_sites tell FOLDER FIRST LAST         a row for each in Markdown, and what they come to
//   drawn_sites fly LIMPET FOLDER FIRST LAST   and before flies discoveries of the seeds that
//                                              FOLDER has no report of yet, but for what `limpet
//                                              check` refuses
//   drawn_sites fly_both LIMPET FOLDER FIRST LAST   and change sessions: objects come and go
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tests/bench/change_worlds/verdict_tally.hpp"
#include "tests/bench/drawn_sites/drawn_site.hpp"
#include "tests/bench/seeded_flights.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

fs::path SiteFolder(const fs::path& root, std::uint64_t seed) {
  return FolderOf(root, "site", seed);
}

struct Fleet {
  std::string limpet;
  fs::path root;
  Fates fates = Fates::kStay;  ///< drawn: both sessions are flown
};

void FlyOne(const Fleet& fleet, std::uint64_t seed) {
  const fs::path folder = SiteFolder(fleet.root, seed);
  if (fs::exists(folder / "run/report.json")) return;
  fs::remove_all(folder / "run");
  const std::string what = WriteDrawnSite(seed, fleet.fates, folder);
  std::ofstream(folder / "what") << what;
  const std::string command = fmt::format(
      "({0} check {1} && {0} survey {1} --sessions {3} --seed {2} --out {1}/run) > {1}/log 2>&1",
      fleet.limpet, folder.string(), seed,
      fleet.fates == Fates::kDrawn ? "discovery,change" : "discovery");
  const int status = std::system(command.c_str());
  if (!fs::exists(folder / "run/report.json")) {
    fmt::print(stderr, "site {}: no report (status {}), see {}/log\n", seed, status,
               folder.string());
  }
}

/// What the flights come to.
struct Sum {
  int flown = 0, home = 0, safe = 0, covered = 0;
  std::size_t missed = 0;    ///< objects
  double way_m = 0.0;        ///< from start to home
  double survey_m = 0.0;     ///< from the survey's start on, where lanes were reckoned
  double lanes_m = 0.0;      ///< of those
  double worst_claim = 0.0;  ///< believed share of the band less the true one
};

void TellOne(const std::string& name, const std::string& what, const nlohmann::json& session,
             Sum& sum) {
  const double way = session.at("path_m"), survey = session.at("survey_path_m");
  const double band = session.at("detected_band");
  const double outside = session.at("outside_region_m"), in_zone = session.at("inside_zone_m");
  const double claim = session.at("water").at("believed_coverage").at("band");
  const std::string ended = session.at("ended");
  const std::size_t missed = session.at("missed").size();
  const auto& lanes = session.at("lanes");
  const double lanes_m = lanes.is_null() ? 0.0 : lanes.at("path_m").get<double>();
  fmt::print(
      "| {} | {} | {} | {:.0f} | {:.0f} | {:.0f} | {:.3f} | {:+.3f} | {} | {:.2f} | {:.2f} |\n",
      name, what, ended, way, survey, lanes_m, band, claim - band, missed, outside, in_zone);
  ++sum.flown;
  sum.home += ended == "home" ? 1 : 0;
  sum.safe += outside < 0.5 && in_zone == 0.0 ? 1 : 0;
  sum.covered += band >= 0.95 ? 1 : 0;
  sum.missed += missed;
  sum.way_m += way;
  sum.worst_claim = std::max(sum.worst_claim, claim - band);
  if (lanes_m > 0.0) sum.survey_m += survey, sum.lanes_m += lanes_m;
}

constexpr const char* kHead =
    "| seed, session | site | ended | way [m] | of the survey [m] | reckoned lanes [m] | band seen "
    "| "
    "claimed "
    "more by | missed | left the region by [m] | in a zone by [m] |\n"
    "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";

void Print(const Sum& sum) {
  fmt::print(
      "\n{} flown: {} ended by their own judgement, {} within 0.5 m of their region and out of "
      "every zone, {} saw 95 % of the band; ",
      sum.flown, sum.home, sum.safe, sum.covered);
  fmt::print(
      "{:.0f} m of way; {:.0f} m of survey where the best of reckoned lanes are {:.0f} m; "
      "objects missed: {}; claimed at most {:.3f} more of the band than was seen\n",
      sum.way_m, sum.survey_m, sum.lanes_m, sum.missed, sum.worst_claim);
}

void Tell(const fs::path& root, Seeds seeds) {
  fmt::print("{}", kHead);
  Sum sum;
  VerdictTally tally;
  bool has_changes = false;
  for (std::uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
    const fs::path folder = SiteFolder(root, seed);
    std::ifstream report(folder / "run/report.json");
    if (!report) continue;
    std::string what;
    std::getline(std::ifstream(folder / "what"), what);
    const nlohmann::json flown = nlohmann::json::parse(report);
    for (const char* session : {"discovery", "change"}) {
      if (!flown.at("sessions").contains(session)) continue;
      TellOne(fmt::format("{}, {}", seed, session), what, flown.at("sessions").at(session), sum);
    }
    has_changes = has_changes || flown.at("sessions").contains("change");
    tally.Add(seed, flown);
  }
  Print(sum);
  if (has_changes) fmt::print("\n{}", tally.Text());
}

int Main(const std::vector<std::string>& args) {
  const auto command = FlightCommandOf(args, {"fly", "fly_both"});
  if (!command) {
    fmt::print(stderr,
               "usage: drawn_sites fly|fly_both LIMPET FOLDER FIRST LAST | tell FOLDER FIRST "
               "LAST\n");
    return 2;
  }
  if (command->verb != "tell") {
    const Fleet fleet{.limpet = command->limpet,
                      .root = command->root,
                      .fates = command->verb == "fly_both" ? Fates::kDrawn : Fates::kStay};
    EachSeedAtOnce(command->seeds, [&fleet](std::uint64_t seed) { FlyOne(fleet, seed); });
  }
  Tell(command->root, command->seeds);
  return 0;
}

}  // namespace
}  // namespace limpet

int main(int argc, char** argv) { return limpet::Main({argv + 1, argv + argc}); }
