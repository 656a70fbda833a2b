// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"
#include "limpet/shapes/shape.hpp"

namespace limpet {

/// Goes straight to a point where an aborted mission ends, and stays there: its `endflag`s say that
/// it has arrived. Parameters are spelled as existing MOOS-IvP missions spell them.
class BHV_AbortToPoint final : public Behavior {
 public:
  struct Params {
    std::optional<MapPoint> point{};
    MetersPerSecond speed{1.0};
    Meters radius{25.0}, slip_radius{200.0};
    void Describe(ParamCollector& visit);
  };
  explicit BHV_AbortToPoint(const Params& params) : params_(params) {}

  [[nodiscard]] bool TakeOver(const Behavior& former,
                              const std::vector<std::string>& keys) override;
  /// It holds the vehicle there: nobody else may want to.
  [[nodiscard]] bool IsPerpetual() const override { return true; }
  void Start(const VehicleState& state) override;
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;

 private:
  [[nodiscard]] bool Arrives(double distance);

  Params params_;
  bool has_arrived_ = false;
  std::optional<double> nearest_;  ///< least distance since it began to run [m]
};

}  // namespace limpet
