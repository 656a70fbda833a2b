// SPDX-License-Identifier: MIT
// What benchmarks share that fly missions drawn from seeds: a folder for each, a core for each.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "limpet/core/number_text.hpp"

namespace limpet {

/// From the first to the last.
struct Seeds {
  std::uint64_t first = 1, last = 1;
};

/// Nothing unless both are whole numbers, the first no greater than the last.
inline std::optional<Seeds> SeedsOf(std::string_view first, std::string_view last) {
  const auto low = ParseInteger(first), high = ParseInteger(last);
  if (!low || !high || *low < 0 || *high < *low) return std::nullopt;
  return Seeds{static_cast<std::uint64_t>(*low), static_cast<std::uint64_t>(*high)};
}

/// What such a benchmark is asked to do.
struct FlightCommand {
  std::string verb;    ///< `tell`, or how to fly first
  std::string limpet;  ///< the program; empty to tell
  std::filesystem::path root;
  Seeds seeds;
};

/// Reads `tell FOLDER FIRST LAST`, or a verb of `ways` with LIMPET FOLDER FIRST LAST; nothing of
/// anything else.
inline std::optional<FlightCommand> FlightCommandOf(const std::vector<std::string>& args,
                                                    const std::vector<std::string>& ways) {
  const bool is_to_fly = args.size() == 5 && std::ranges::count(ways, args[0]) > 0;
  const bool is_to_tell = args.size() == 4 && args[0] == "tell";
  if (!is_to_fly && !is_to_tell) return std::nullopt;
  const auto seeds = SeedsOf(args[args.size() - 2], args.back());
  if (!seeds) return std::nullopt;
  return FlightCommand{.verb = args[0],
                       .limpet = is_to_fly ? std::filesystem::absolute(args[1]).string() : "",
                       .root = args[args.size() - 3],
                       .seeds = *seeds};
}

/// Where a seed's mission is written; its run lies in `run` there.
inline std::filesystem::path FolderOf(const std::filesystem::path& root, std::string_view what,
                                      std::uint64_t seed) {
  return root / fmt::format("{}{}", what, seed);
}

/// Calls visit(seed) for each, as many at a time as there are cores.
template <class Visit>
void EachSeedAtOnce(Seeds seeds, const Visit& visit) {
  std::atomic<std::uint64_t> next = seeds.first;
  const auto work = [&] {
    for (std::uint64_t seed = next++; seed <= seeds.last; seed = next++)
      visit(seed);
  };
  std::vector<std::jthread> workers;
  for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
    workers.emplace_back(work);
}

}  // namespace limpet
