// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/helm/act_list.hpp"
#include "limpet/helm/behavior.hpp"

namespace limpet {

/// Prefers one depth. Parameters are spelled as existing MOOS-IvP missions spell them.
class BHV_ConstantDepth final : public Behavior {
 public:
  struct Params {
    Meters depth{0.0};
    Meters peakwidth{3.0};
    Meters basewidth{100.0};
    double summit_delta = 50.0;
    std::string mismatch_variable{};
    void Describe(ParamCollector& visit);
  };
  explicit BHV_ConstantDepth(const Params& params) : params_(params) {}
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;
  [[nodiscard]] std::vector<BehaviorAct> Idle(const VehicleState& state) override;

 private:
  void TellMismatch(const VehicleState& state, ActList& acts) const;

  Params params_;
};

}  // namespace limpet
