// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"

namespace limpet {

/// Wants no more than a depth: all down to it are as good. Parameters are spelled as existing
/// MOOS-IvP missions spell them.
class BHV_MaxDepth final : public Behavior {
 public:
  struct Params {
    Meters max_depth{0.0};
    Meters basewidth{100.0};
    std::string slack_variable{};
    void Describe(ParamCollector& visit);
  };
  explicit BHV_MaxDepth(const Params& params) : params_(params) {}
  [[nodiscard]] bool IsConstraint() const override { return true; }
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;

 private:
  Params params_;
};

}  // namespace limpet
