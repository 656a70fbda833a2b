// SPDX-License-Identifier: MIT
// Does a verdict mean what it says where the world is not the one believed? Two sessions each in
// worlds drawn at random, flown in closed loop by the command itself; what it said beside what was
// so.
//   change_worlds fly LIMPET FOLDER FIRST LAST          flies seeds that FOLDER has no report of
//   yet change_worlds fly_waters LIMPET FOLDER FIRST LAST   each session in water of its own
//   change_worlds tell FOLDER FIRST LAST                figures of those that have one
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tests/bench/change_worlds/drawn_world.hpp"
#include "tests/bench/change_worlds/verdict_tally.hpp"
#include "tests/bench/seeded_flights.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

fs::path WorldFolder(const fs::path& root, std::uint64_t seed) {
  return FolderOf(root, "world", seed);
}

/// One command for both sessions; or, where each has its water, one each and then the report.
std::string FlightOf(const std::string& limpet, const fs::path& folder, std::uint64_t seed,
                     bool has_two_waters) {
  const std::string fly =
      fmt::format("{0} survey {1} --seed {2} --out {1}/run", limpet, folder.string(), seed);
  if (!has_two_waters) return fmt::format("{} > {}/log 2>&1", fly, folder.string());
  std::string other;
  for (const char* app : {"uSimVehicle", "uSimSensors", "uSimCamera"})
    other += fmt::format(" --set {}.scenario=scenario_change.yaml", app);
  return fmt::format(
      "({0} --sessions discovery; {0} --sessions change{1}; {2} report {3}/run) > {3}/log 2>&1",
      fly, other, limpet, folder.string());
}

struct Fleet {
  std::string limpet;
  fs::path root;
  bool has_two_waters = false;
};

void FlyOne(const Fleet& fleet, std::uint64_t seed) {
  const fs::path folder = WorldFolder(fleet.root, seed);
  if (fs::exists(folder / "run/report.json")) return;
  fs::remove_all(folder / "run");
  WriteDrawnWorld(seed, folder);
  const std::string command = FlightOf(fleet.limpet, folder, seed, fleet.has_two_waters);
  const int status = std::system(command.c_str());
  if (!fs::exists(folder / "run/report.json")) {
    fmt::print(stderr, "world {}: no report (status {}), see {}/log\n", seed, status,
               folder.string());
  }
}

void Tell(const fs::path& root, Seeds seeds) {
  VerdictTally tally;
  for (std::uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
    std::ifstream in(WorldFolder(root, seed) / "run/report.json");
    if (in) tally.Add(seed, nlohmann::json::parse(in));
  }
  fmt::print("{}", tally.Text());
}

int Main(const std::vector<std::string>& args) {
  const auto command = FlightCommandOf(args, {"fly", "fly_waters"});
  if (!command) {
    fmt::print(
        stderr,
        "usage: change_worlds fly|fly_waters LIMPET FOLDER FIRST LAST | tell FOLDER FIRST LAST\n");
    return 2;
  }
  if (command->verb != "tell") {
    const Fleet fleet{.limpet = command->limpet,
                      .root = command->root,
                      .has_two_waters = command->verb == "fly_waters"};
    EachSeedAtOnce(command->seeds, [&fleet](std::uint64_t seed) { FlyOne(fleet, seed); });
  }
  Tell(command->root, command->seeds);
  return 0;
}

}  // namespace
}  // namespace limpet

int main(int argc, char** argv) { return limpet::Main({argv + 1, argv + argc}); }
