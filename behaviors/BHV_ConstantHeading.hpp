// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/helm/act_list.hpp"
#include "limpet/helm/behavior.hpp"

namespace limpet {

/// Prefers one heading; completes once the vehicle has it, if asked to. Parameters are spelled as
/// existing MOOS-IvP missions spell them.
class BHV_ConstantHeading final : public Behavior {
 public:
  struct Params {
    Radians heading{0.0};
    Radians peakwidth = Radians::FromTextUnit(10.0);
    Radians basewidth = Radians::FromTextUnit(170.0);
    double summit_delta = 25.0;
    Radians complete_threshold = Radians::FromTextUnit(-1.0);
    std::string mismatch_variable{};
    void Describe(ParamCollector& visit);
  };
  explicit BHV_ConstantHeading(const Params& params) : params_(params) {}
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;
  [[nodiscard]] std::vector<BehaviorAct> Idle(const VehicleState& state) override;

 private:
  /// How far the vehicle is off its heading [rad].
  [[nodiscard]] double Off(const VehicleState& state) const;
  void TellMismatch(const VehicleState& state, ActList& acts) const;

  Params params_;
};

}  // namespace limpet
