// SPDX-License-Identifier: MIT
// Missions one after the other, live and at warp, with random faults and killed processes: whether
// each ends as it must, whether memory and open files grow, how fast mail and restarts are.
// usage: build/bin/soak tests/soak/plans/short.moos [folder for what is left; default: none kept]
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "limpet/core/clock.hpp"
#include "limpet/core/config.hpp"
#include "limpet/core/program_search.hpp"
#include "tests/soak/soak_plan.hpp"
#include "tests/soak/soak_run.hpp"
#include "tests/soak/soak_table.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

int SumOf(const std::map<std::string, int>& counts) {
  return std::accumulate(counts.begin(), counts.end(), 0,
                         [](int sum, const auto& count) { return sum + count.second; });
}

void PrintRun(const SoakRun& run) {
  const std::string complaint = run.Complaint();
  fmt::print("run {}: {}, {:.0f} s, {} killed, {} halted{}\n", run.seed,
             run.ended.empty() ? "no end" : run.ended, run.real_s, SumOf(run.kills),
             SumOf(run.stops), complaint.empty() ? "" : "; FAILED: " + complaint);
  std::fflush(stdout);
}

/// True if every bound is kept.
bool PrintVerdicts(const std::vector<SoakVerdict>& verdicts) {
  fmt::print("\n{:<42}{:>12}{:>12}\n", "bound", "measured", "at most");
  for (const SoakVerdict& verdict : verdicts) {
    fmt::print("{:<42}{:>12.2f}{:>12.2f}{}\n", verdict.what, verdict.value, verdict.most,
               verdict.IsKept() ? "" : "  EXCEEDED");
  }
  return std::ranges::all_of(verdicts, &SoakVerdict::IsKept);
}

int Soak(const fs::path& plan_file, const fs::path& kept) {
  const SoakPlan plan = LoadSoakPlan(plan_file);
  const TemporaryFolder scratch;
  const SoakPlaces places{.source = LIMPET_SOURCE_DIR,
                          .programs = fs::read_symlink("/proc/self/exe").parent_path(),
                          .scratch = kept.empty() ? scratch.path() : kept};
  Random random(static_cast<std::uint64_t>(plan.seed));
  std::vector<SoakRun> runs;
  const Seconds end = SteadyTime() + plan.duration;
  for (int seed = plan.seed; SteadyTime() < end; ++seed) {
    runs.push_back(RunOnce(plan, places, seed, random));
    PrintRun(runs.back());
    if (kept.empty() && runs.back().Complaint().empty()) {
      fs::remove_all(places.scratch / fmt::format("run_{}", seed));
    }
  }
  fmt::print("\n{}", AppTable(plan, runs));
  return PrintVerdicts(VerdictsOf(plan, runs)) ? 0 : 1;
}

}  // namespace
}  // namespace limpet

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty() || words.size() > 2) {
    fmt::print(stderr, "usage: soak <plan.moos> [folder to keep the runs in]\n");
    return 2;
  }
  try {
    return limpet::Soak(words[0], words.size() > 1 ? words[1] : "");
  } catch (const std::exception& error) {
    fmt::print(stderr, "soak: {}\n", error.what());
    return 2;
  }
}
