// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "limpet/core/units.hpp"

namespace limpet {

/// Refuses what is stamped in the future, or with no time at all, and counts it by variable: a
/// sample that an app believes to be newer than all that follow would stop it until that time has
/// come. Behind vehicle time is no such thing: mail may be late, and who needs it fresh looks at
/// its age.
class StampGuard {
 public:
  /// Real time by which the clocks of two machines of a community may differ.
  static constexpr Seconds kTolerance{0.5};
  /// A variable whose stamps have been right for this long (real time) is in order again.
  static constexpr Seconds kQuiet{2.0};

  struct Refused {
    std::int64_t count = 0;
    Seconds farthest;  ///< ahead of vehicle time; infinite if it was no number
    Seconds last;      ///< vehicle time of the last refusal
    bool is_up = false;
  };
  enum class Verdict { kGood, kGoodAgain, kRefused };

  /// `warp`: MOOS time per real time.
  explicit StampGuard(double warp) : warp_(warp) {}

  /// Judges a stamp of `variable`, at `now`. kGoodAgain: the first one after a refusal and then
  /// kQuiet.
  [[nodiscard]] Verdict Judge(const std::string& variable, Seconds stamp, Seconds now);
  /// Refusals by variable, for variables that were ever refused.
  [[nodiscard]] const std::map<std::string, Refused>& refused() const { return refused_; }

 private:
  double warp_;
  std::map<std::string, Refused> refused_;
};

}  // namespace limpet
