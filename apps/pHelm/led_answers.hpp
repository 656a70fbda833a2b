// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>

#include "limpet/core/units.hpp"

namespace limpet {

/// Whether the helm that is led takes what it is told: each update that this one sends, and what
/// the other's IVPHELM_UPDATE_RESULT says of it.
class LedAnswers {
 public:
  /// An update was sent in `variable`.
  void Sent(const std::string& variable, Seconds now);
  /// Mail of IVPHELM_UPDATE_RESULT: `bhv=way,var=SURVEY_WAY,time=2.10,result=param_error,val=...`.
  void Hear(const std::string& result);
  /// What is wrong: an update was refused, or nobody has answered to one for so long that nobody
  /// will.
  [[nodiscard]] std::optional<std::string> Complaint(Seconds now) const;

 private:
  struct Line {
    std::optional<Seconds> unanswered_since;
    std::string refusal;  ///< the last answer, if that was one
  };
  std::map<std::string, Line> lines_;  ///< by variable
};

}  // namespace limpet
