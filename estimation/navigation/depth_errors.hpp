// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "estimation/navigation/navigator_params.hpp"
#include "estimation/smoothing/smoother.hpp"
#include "limpet/core/long_ago.hpp"

namespace limpet {

/// What depths are off for long, as border variables of the smoother: the pressure sensor's zero
/// and the air's pressure, which wander, and how deep the vehicle floats when its antenna is out of
/// the water. `params` and `smoother` must outlive it.
class DepthErrors {
 public:
  DepthErrors(const NavigatorParams& params, Smoother& smoother)
      : params_(params), smoother_(smoother) {}

  /// The chain begins at `t` [s].
  void Begin(double t);
  [[nodiscard]] bool is_estimated() const { return slot_.has_value(); }
  [[nodiscard]] std::optional<int> slot() const { return slot_; }
  /// What the sensor reads too deep, as estimated now [m].
  [[nodiscard]] double Bias() const;
  /// A depth measured at `t`.
  [[nodiscard]] Term Measured(double t, Meters depth, Meters sigma);
  /// The antenna is out of the water, at the smoother's newest pose; nothing if that pose lies
  /// where it cannot be.
  [[nodiscard]] std::optional<Term> Surfaced(double t);

 private:
  int SlotAt(double t);

  const NavigatorParams& params_;
  Smoother& smoother_;
  std::optional<int> slot_;
  double since_ = 0.0, surfaced_t_ = kLongAgo;
};

}  // namespace limpet
