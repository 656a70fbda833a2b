// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

namespace limpet {

/// How many flights, and the seed of the first.
struct DryRunSeeds {
  std::uint64_t first = 1;
  int count = 3;
};

/// Flies a mission embedded, once for each seed, and prints a line for each and a verdict. Exit
/// code 0 or 3. `path`: a mission folder or .moos file. Throws UsageError for a mission that such a
/// flight says nothing of.
[[nodiscard]] int CheckByDryRun(const std::filesystem::path& path, const DryRunSeeds& seeds);

}  // namespace limpet
