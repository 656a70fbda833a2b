// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "limpet/planning/ground.hpp"
#include "limpet/planning/objective.hpp"
#include "limpet/planning/search_term.hpp"

namespace limpet {

/// Values paths step by step, as searches lengthen them, by every term of an objective: new ground,
/// targets, and what behaviors add. Allocates nothing after construction.
class PathValuer {
 public:
  /// Targets further from `start` than `reach` [m] are left out: no path of that length shows them.
  PathValuer(const Objective& objective, const Ground& ground, const Pose2& start, double reach);

  /// Worth of `step` [m of path] without its length, which the search pays; notes its events.
  [[nodiscard]] double Worth(const PathStep& step);

  [[nodiscard]] std::size_t Mark() const { return events_.Mark(); }
  void Rewind(std::size_t mark) { events_.Rewind(mark); }
  /// Events since `mark`, for Replay.
  [[nodiscard]] std::span<const std::uint32_t> EventsSince(std::size_t mark) const {
    return events_.Since(mark);
  }
  void Replay(std::span<const std::uint32_t> events) {
    for (const std::uint32_t event : events) {
      events_.Add(event);
    }
  }

 private:
  struct Entry {
    std::shared_ptr<const SearchTerm> term;
    std::size_t first_event = 0;
  };
  std::vector<Entry> entries_;
  PathEvents events_{0};
};

}  // namespace limpet
