// SPDX-License-Identifier: MIT
// Cuts the power 10,000 times amid each kind of file, and says what was lost that had to be there:
//   power_cuts [cuts of each kind] [first seed]
#include "tests/support/power_cuts.hpp"

#include <chrono>
#include <cstdlib>
#include <functional>

#include <fmt/format.h>

using namespace limpet;  // NOLINT(google-build-using-namespace): one program

int main(int argc, char** argv) {
  constexpr int kCutsOfALife = 50;
  const int cuts = argc > 1 ? std::atoi(argv[1]) : 10'000;
  const std::uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1000;
  struct Kind {
    const char* name;
    std::function<PowerCuts(std::uint64_t, int)> cut;
  };
  bool is_sound = true;
  fmt::print("{:<14}{:>8}{:>8}{:>12}{:>8}\n", "file", "cuts", "lossy", "complaints", "s");
  for (const Kind& kind :
       {Kind{"log", CutLog}, Kind{"packed log", CutPackedLog}, Kind{"session", CutSession},
        Kind{"journal", CutJournal}, Kind{"whole file", CutWholeFile}}) {
    const auto begin = std::chrono::steady_clock::now();
    PowerCuts all;
    for (std::uint64_t seed = first; all.cuts < cuts; ++seed) {
      const PowerCuts life = kind.cut(seed, kCutsOfALife);
      all.cuts += kCutsOfALife;
      all.lossy += life.lossy;
      for (const std::string& complaint : life.complaints) {
        fmt::print("seed {}: {}\n", seed, complaint);
        all.complaints.push_back(complaint);
      }
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    fmt::print("{:<14}{:>8}{:>8}{:>12}{:>8.1f}\n", kind.name, all.cuts, all.lossy,
               all.complaints.size(), took.count());
    is_sound = is_sound && all.complaints.empty();
  }
  return is_sound ? 0 : 1;
}
