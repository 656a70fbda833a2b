// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/core/units.hpp"
#include "limpet/helm/motion_decision.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {

/// The arbiter's last decision as HELM_MOTION says it.
[[nodiscard]] HelmMotion RecordOf(const MotionArbiter& arbiter, const MotionDecision& decision);

/// When HELM_MOTION is due: once a second, and when others have a say than before.
class MotionRecordRate {
 public:
  [[nodiscard]] bool IsDue(const MotionDecision& decision, Seconds now);

 private:
  std::vector<std::string> told_;
  std::optional<Seconds> told_at_;
};

}  // namespace limpet
