// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>

#include "limpet/app/warning_text.hpp"
#include "limpet/core/units.hpp"
#include "limpet/topics/warning.hpp"

namespace limpet {

/// The warnings of one app that stand now, and when to tell of them: at once what is raised or
/// cleared, and every few seconds what a standing one says anew, so that counts move and nobody is
/// flooded.
class WarningBoard {
 public:
  /// Least real time between a word and one that only changes texts.
  static constexpr Seconds kTextPeriod{2.0};
  enum class Change { kNone, kText, kRaised };

  /// `warp`: MOOS time per real time.
  explicit WarningBoard(double warp = 1.0) : text_period_(kTextPeriod * warp) {}

  /// A warning that stands keeps its `since`; its text follows.
  Change Raise(const WarningId& id, const std::string& text, Seconds now);
  /// False if it does not stand.
  bool Clear(const WarningId& id);
  /// Warnings that stand now, by id.
  [[nodiscard]] const std::map<std::string, StandingWarning>& standing() const { return standing_; }
  /// The value of <APP>_WARNINGS if it is to be written now; counts as written.
  [[nodiscard]] std::optional<std::string> TakeNews(Seconds now);

 private:
  Seconds text_period_;
  std::map<std::string, StandingWarning> standing_;
  bool has_change_ = false;  ///< one was raised or cleared
  bool has_new_text_ = false;
  Seconds told_;
};

}  // namespace limpet
