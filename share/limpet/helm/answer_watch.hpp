// SPDX-License-Identifier: MIT
// A behavior may be anybody's code: how long it takes to answer must not hold the helm up for good.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "limpet/core/units.hpp"

namespace limpet {

/// Real time, from any origin. A helm that runs embedded has none: its runs are the same bit by
/// bit, however fast the machine is.
using RealClock = std::function<Seconds()>;

/// Takes the time that behaviors need to answer. One that was late twice in a row is not asked for
/// a hundred times as long as it took; then once more. Without a clock nobody is late.
class AnswerWatch {
 public:
  /// Longer than this is late.
  static constexpr Seconds kLate{0.5};
  /// So long may many calls take together that are one question, none of them late.
  static constexpr Seconds kLateInAll{3.0};

  explicit AnswerWatch(RealClock clock) : clock_(std::move(clock)) {}

  /// Has `owner` answer by `work`, unless it rests. Nothing if that was in time, else what is to be
  /// said of it.
  template <class Work>
  std::optional<std::string> Ask(const std::string& owner, const Work& work) {
    if (std::optional<std::string> rest = RestOf(owner)) return rest;
    const Seconds began = Now();
    work();
    const Seconds took = Now() - began;
    return Judge(owner, took, took > kLate);
  }
  /// A question of many calls, `next(i)` for each i below `count`: once one of them is late, or all
  /// together, the rest is not asked.
  template <class Next>
  std::optional<std::string> AskEach(const std::string& owner, std::size_t count,
                                     const Next& next) {
    if (std::optional<std::string> rest = RestOf(owner)) return rest;
    const Seconds began = Now();
    Seconds last = began, longest(0.0);
    for (std::size_t i = 0; i < count && longest <= kLate && last - began <= kLateInAll; ++i) {
      next(i);
      const Seconds now = Now();
      longest = std::max(longest, now - last);
      last = now;
    }
    const Seconds all = last - began;
    return Judge(owner, all, longest > kLate || all > kLateInAll);
  }
  /// A call that has to be made, of anybody's: what is to be said if it takes long.
  template <class Work>
  [[nodiscard]] std::optional<std::string> Time(const Work& work) const {
    const Seconds began = Now();
    work();
    return ComplaintOf(Now() - began);
  }
  /// Real time, from any origin; 0 without a clock.
  [[nodiscard]] Seconds Now() const { return clock_ ? clock_() : Seconds(0.0); }

 private:
  struct Lateness {
    int in_a_row = 0;
    Seconds took{0.0};   ///< the last
    Seconds since{0.0};  ///< when it ended
  };
  [[nodiscard]] std::optional<std::string> RestOf(const std::string& owner) const;
  [[nodiscard]] std::optional<std::string> Judge(const std::string& owner, Seconds took,
                                                 bool is_late);
  [[nodiscard]] static std::optional<std::string> ComplaintOf(Seconds took);

  RealClock clock_;
  std::map<std::string, Lateness> late_;  ///< whose last answer was late
};

}  // namespace limpet
