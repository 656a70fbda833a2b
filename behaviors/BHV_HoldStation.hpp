// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"

namespace limpet {

/// Stops, and keeps the heading at which it began: for the dive and the ascent.
class BHV_HoldStation final : public Behavior {
 public:
  struct Params {
    template <class Visitor>
    void Describe(Visitor&) {}
  };
  explicit BHV_HoldStation(const Params&) {}
  void Start(const VehicleState& state) override { heading_ = state.nav.yaw; }
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;

 private:
  std::optional<double> heading_;
};

}  // namespace limpet
