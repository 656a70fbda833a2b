// SPDX-License-Identifier: MIT
// Lives of files on a disk whose power is cut: what must be there afterwards, and what is not.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace limpet {

/// What came of some lives, each cut many times.
struct PowerCuts {
  int cuts = 0;
  /// Cuts that lost something: the disk had more than nothing to forget.
  int lossy = 0;
  std::vector<std::string> complaints;  ///< empty: everything that had to be there was
};

/// A log with binary values, a table and system messages, whose logger is sometimes started again:
/// it opens, everything older than 1 s is there, and it can be gone on with.
[[nodiscard]] PowerCuts CutLog(std::uint64_t seed, int cuts);
/// A compressed log: it is there, plain or packed, and whole once it was closed.
[[nodiscard]] PowerCuts CutPackedLog(std::uint64_t seed, int cuts);
/// Generations of a session that keep files of the one before, of which the last is set aside for
/// another one: the last that was said to be saved is there, or a later one.
[[nodiscard]] PowerCuts CutSession(std::uint64_t seed, int cuts);
/// A journal: its records are those that were appended, from the first on without a gap, and those
/// older than 1 s are among them.
[[nodiscard]] PowerCuts CutJournal(std::uint64_t seed, int cuts);
/// A file that is written again and again: it is whole, and no older than what was last done with.
[[nodiscard]] PowerCuts CutWholeFile(std::uint64_t seed, int cuts);

}  // namespace limpet
