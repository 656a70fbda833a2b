// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>

#include "limpet/core/units.hpp"

namespace limpet {

/// How often something happens: over the last eight seconds, or the last two events if those lie
/// further apart. Falls as soon as an event is overdue, and costs a few dozen numbers at any rate.
class RateEstimate {
 public:
  void Note(Seconds now);
  /// Hz; 0 until there are two events.
  [[nodiscard]] double At(Seconds now) const;
  /// How many events there were since the first.
  [[nodiscard]] std::uint64_t events() const { return events_; }

 private:
  struct Mark {
    Seconds time;
    std::uint64_t events;  ///< up to then, that one included
  };
  std::deque<Mark> marks_;
  Seconds last_;
  std::uint64_t events_ = 0;
};

}  // namespace limpet
