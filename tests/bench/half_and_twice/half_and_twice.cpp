// SPDX-License-Identifier: MIT
// Does a mission hold where the world is not the one believed? Each thing that whoever navigates
// and maps assumes, halved and doubled in the simulator alone; both sessions, flown in closed loop
// by the command itself, with the boxes camera.
//   half_and_twice fly LIMPET MISSION FOLDER FIRST LAST   flies what FOLDER has no report of yet
//   half_and_twice tell FOLDER FIRST LAST                 the page of those that have one
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

#include "tests/bench/half_and_twice/changed_world.hpp"
#include "tests/bench/half_and_twice/outcome_row.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

struct Seeds {
  std::uint64_t first = 1, last = 1;
};

fs::path RunOf(const fs::path& folder, const ChangedWorld& world, std::uint64_t seed) {
  return folder / world.name / fmt::format("{}", seed);
}

struct Flight {
  const ChangedWorld* world = nullptr;
  std::uint64_t seed = 1;
};

std::vector<Flight> FlightsOf(const std::vector<ChangedWorld>& worlds, Seeds seeds) {
  std::vector<Flight> flights;
  for (std::uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
    for (const ChangedWorld& world : worlds)
      flights.push_back({&world, seed});
  }
  return flights;
}

void FlyOne(const std::string& limpet, const fs::path& folder, const Flight& flight) {
  const fs::path run = RunOf(folder, *flight.world, flight.seed);
  if (fs::exists(run / "report.json")) return;
  fs::remove_all(run);
  const fs::path mission = folder / flight.world->name / "mission";
  const std::string command = fmt::format(
      "{} survey {} --seed {} --set uSimCamera.camera=boxes{} --out {} > {}.log 2>&1", limpet,
      mission.string(), flight.seed, flight.world->settings, run.string(), run.string());
  const int status = std::system(command.c_str());
  if (!fs::exists(run / "report.json")) {
    fmt::print(stderr, "{}, seed {}: no report (status {}), see {}.log\n", flight.world->name,
               flight.seed, status, run.string());
    return;
  }
  for (const char* session : {"discovery", "change"})  // a hundred megabytes each
    fs::remove_all(run / session);
}

void Fly(const std::string& limpet, const fs::path& mission, const fs::path& folder, Seeds seeds) {
  const std::vector<ChangedWorld> worlds = ChangedWorlds();
  for (const ChangedWorld& world : worlds)
    WriteMission(world, mission, folder / world.name / "mission");
  const std::vector<Flight> flights = FlightsOf(worlds, seeds);
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < flights.size(); i = next++)
      FlyOne(limpet, folder, flights[i]);
  };
  std::vector<std::jthread> workers;
  for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
    workers.emplace_back(work);
}

void Tell(const fs::path& folder, Seeds seeds) {
  fmt::print("{}", OutcomePageHead(seeds.first, seeds.last));
  for (const ChangedWorld& world : ChangedWorlds()) {
    OutcomeRow row;
    for (std::uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
      std::ifstream in(RunOf(folder, world, seed) / "report.json");
      if (in) row.Add(nlohmann::json::parse(in));
    }
    fmt::print("| {} {}", world.what, row.Text());
  }
}

std::uint64_t Number(const std::string& text) { return std::strtoull(text.c_str(), nullptr, 10); }

}  // namespace
}  // namespace limpet

int main(int argc, char** argv) {
  const std::vector<std::string> args(argv + 1, argv + argc);
  if (args.size() == 6 && args[0] == "fly") {
    const limpet::Seeds seeds{limpet::Number(args[4]), limpet::Number(args[5])};
    limpet::Fly(args[1], args[2], args[3], seeds);
    limpet::Tell(args[3], seeds);
    return 0;
  }
  if (args.size() == 4 && args[0] == "tell") {
    limpet::Tell(args[1], {limpet::Number(args[2]), limpet::Number(args[3])});
    return 0;
  }
  fmt::print(stderr,
             "usage: half_and_twice fly LIMPET MISSION FOLDER FIRST LAST | tell FOLDER FIRST "
             "LAST\n");
  return 2;
}
