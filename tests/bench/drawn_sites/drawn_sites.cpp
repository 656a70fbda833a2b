// SPDX-License-Identifier: MIT
// How does a survey go on a site that nobody has tuned it on? Discovery sessions over areas drawn
// at random, flown in closed loop by the command itself.
//   drawn_sites fly LIMPET FOLDER FIRST LAST   flies the seeds that FOLDER has no report of yet, a
//                                              core each; what `limpet check` refuses is not flown
//   drawn_sites tell FOLDER FIRST LAST         a row for each in Markdown, and what they come to
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tests/bench/drawn_sites/drawn_site.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

struct Seeds {
  std::uint64_t first = 1, last = 1;
};

fs::path FolderOf(const fs::path& root, std::uint64_t seed) {
  return root / fmt::format("site{}", seed);
}

void FlyOne(const std::string& limpet, const fs::path& root, std::uint64_t seed) {
  const fs::path folder = FolderOf(root, seed);
  if (fs::exists(folder / "run/report.json")) return;
  fs::remove_all(folder / "run");
  std::ofstream(folder / "what") << WriteDrawnSite(seed, folder);
  const std::string command = fmt::format(
      "({0} check {1} && {0} survey {1} --sessions discovery --seed {2} --out {1}/run) > {1}/log "
      "2>&1",
      limpet, folder.string(), seed);
  if (std::system(command.c_str()) != 0 && !fs::exists(folder / "run/report.json")) {
    fmt::print(stderr, "site {}: not flown, see {}/log\n", seed, folder.string());
  }
}

void Fly(const std::string& limpet, const fs::path& root, Seeds seeds) {
  for (std::uint64_t seed = seeds.first; seed <= seeds.last; ++seed)
    fs::create_directories(FolderOf(root, seed));
  std::atomic<std::uint64_t> next = seeds.first;
  const auto work = [&] {
    for (std::uint64_t seed = next++; seed <= seeds.last; seed = next++)
      FlyOne(limpet, root, seed);
  };
  std::vector<std::jthread> workers;
  for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
    workers.emplace_back(work);
}

/// What the flights come to.
struct Sum {
  int flown = 0, home = 0, safe = 0, covered = 0;
  double way_m = 0.0, lanes_m = 0.0;  ///< of those for which lanes were reckoned
  double worst_claim = 0.0;           ///< believed share of the band less the true one
};

void TellOne(const std::string& what, std::uint64_t seed, const nlohmann::json& session, Sum& sum) {
  const double way = session.at("path_m"), band = session.at("detected_band");
  const double outside = session.at("outside_region_m"), in_zone = session.at("inside_zone_m");
  const double claim = session.at("water").at("believed_coverage").at("band");
  const std::string ended = session.at("ended");
  const auto& lanes = session.at("lanes");
  const double lanes_m = lanes.is_null() ? 0.0 : lanes.at("path_m").get<double>();
  fmt::print("| {} | {} | {} | {:.0f} | {:.0f} | {:.3f} | {:+.3f} | {:.2f} | {:.2f} |\n", seed,
             what, ended, way, lanes_m, band, claim - band, outside, in_zone);
  ++sum.flown;
  sum.home += ended == "home" ? 1 : 0;
  sum.safe += outside < 0.5 && in_zone == 0.0 ? 1 : 0;
  sum.covered += band >= 0.95 ? 1 : 0;
  sum.worst_claim = std::max(sum.worst_claim, claim - band);
  if (lanes_m > 0.0) sum.way_m += way, sum.lanes_m += lanes_m;
}

void Tell(const fs::path& root, Seeds seeds) {
  fmt::print(
      "| seed | site | ended | way [m] | reckoned lanes [m] | band seen | claimed more by | left "
      "the "
      "region by [m] | in a zone by [m] |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- "
      "|\n");
  Sum sum;
  for (std::uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
    const fs::path folder = FolderOf(root, seed);
    std::ifstream report(folder / "run/report.json");
    if (!report) continue;
    std::string what;
    std::getline(std::ifstream(folder / "what"), what);
    TellOne(what, seed, nlohmann::json::parse(report).at("sessions").at("discovery"), sum);
  }
  fmt::print(
      "\n{} flown: {} ended by their own judgement, {} within 0.5 m of their region and out of "
      "every "
      "zone, {} saw 95 % of the band; {:.0f} m of way, where the best of reckoned lanes are {:.0f} "
      "m; "
      "claimed at most {:.3f} more of the band than was seen\n",
      sum.flown, sum.home, sum.safe, sum.covered, sum.way_m, sum.lanes_m, sum.worst_claim);
}

int Main(const std::vector<std::string>& args) {
  if (args.size() == 5 && args[0] == "fly") {
    Fly(fs::absolute(args[1]).string(), args[2], {std::stoul(args[3]), std::stoul(args[4])});
    return EXIT_SUCCESS;
  }
  if (args.size() == 4 && args[0] == "tell") {
    Tell(args[1], {std::stoul(args[2]), std::stoul(args[3])});
    return EXIT_SUCCESS;
  }
  fmt::print(stderr, "usage: drawn_sites fly LIMPET FOLDER FIRST LAST | tell FOLDER FIRST LAST\n");
  return 2;
}

}  // namespace
}  // namespace limpet

int main(int argc, char** argv) { return limpet::Main({argv + 1, argv + argc}); }
