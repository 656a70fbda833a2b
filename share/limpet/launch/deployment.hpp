// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "limpet/core/units.hpp"

namespace limpet {

/// What tells whether a mission is under way. Empty texts: not heard yet.
struct DeploymentSigns {
  bool is_all_up = false;
  bool has_helm = false, has_survey = false;  ///< among what was launched
  int helm_words = 0;       ///< times that IVPHELM_STATE was heard; one may be of a former helm
  std::string deploy{};     ///< DEPLOY as it stands
  std::string helm_stop{};  ///< IVPHELM_ALLSTOP
  std::string phase{};      ///< SURVEY_PHASE
  bool has_ended = false;   ///< MISSION_END was heard
};

/// Writes DEPLOY = true when it can have effect, and sees to it that it has. A helm writes the
/// mission's `initialize DEPLOY = false` in its first iteration, just before its first
/// IVPHELM_STATE: what is written before that is lost. Pure: no clock, no mail.
class Deployment {
 public:
  static constexpr Seconds kAgainAfter{1.0};  ///< real time, as all here
  static constexpr Seconds kWarnAfter{10.0};
  static constexpr int kMostWrites = 10;

  explicit Deployment(bool is_wanted) : is_done_(!is_wanted) {}

  struct Step {
    bool writes = false;  ///< DEPLOY = true is to be written now
    std::string says{};   ///< for the terminal; empty: nothing
  };
  [[nodiscard]] Step Mind(const DeploymentSigns& signs, Seconds now);
  [[nodiscard]] bool has_written() const { return writes_ > 0; }
  /// Why it is not under way though it should be; empty if all is well.
  [[nodiscard]] const std::string& warning() const { return warning_; }

 private:
  [[nodiscard]] Step Write(std::string says, Seconds now);
  [[nodiscard]] Step WarnIfDue(const DeploymentSigns& signs, Seconds now);

  bool is_done_;
  int writes_ = 0;
  Seconds last_write_{};
  std::optional<Seconds> ready_since_;  ///< all up
  std::string warning_;
};

}  // namespace limpet
