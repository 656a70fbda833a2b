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
  /// The depth [m] that fixes have come from lately, if no antenna is out of the water there: the
  /// sensor was not zeroed.
  [[nodiscard]] std::optional<double> surface_reading() const {
    return deep_fixes_ >= kEnoughDeepFixes ? std::optional(deep_z_ + Bias()) : std::nullopt;
  }

 private:
  static constexpr int kEnoughDeepFixes = 10;  ///< in a row
  int SlotAt(double t);

  const NavigatorParams& params_;
  Smoother& smoother_;
  std::optional<int> slot_;
  double since_ = 0.0, surfaced_t_ = kLongAgo;
  int deep_fixes_ = 0;   ///< in a row
  double deep_z_ = 0.0;  ///< of the last of them [m]
};

}  // namespace limpet
