// SPDX-License-Identifier: MIT
// How far one can see in this water, as a probability over visibilities.
#pragma once

#include <Eigen/Core>

#include "limpet/core/units.hpp"
#include "limpet/topics/mapping.hpp"

namespace limpet {

/// One number for each visibility that is considered, clearest water last.
struct PerVisibility : Eigen::Array<double, 24, 1> {
  static constexpr int kCount = 24;
  using Base = Eigen::Array<double, kCount, 1>;
  // NOLINTNEXTLINE(google-explicit-constructor): a number that holds in any water is one.
  PerVisibility(double everywhere = 0.0) : Base(Base::Constant(everywhere)) {}
  template <class Derived>
  // NOLINTNEXTLINE(google-explicit-constructor): sums and products are, too.
  PerVisibility(const Eigen::ArrayBase<Derived>& other) : Base(other) {}
};

/// What is believed of the visibility: weights over a fixed grid of visibilities, evenly spaced in
/// their logarithm. "Visibility" is what explains the detector's boxes by DetectionModel; how that
/// compares with a diver's is known to `kDetectorSpread` only.
class VisibilityBelief {
 public:
  static constexpr double kLeast_m = 0.6;
  static constexpr double kMost_m = 36.0;
  /// Standard deviation of ln(visibility in the model's terms / visibility of the water).
  static constexpr double kDetectorSpread = 0.3;

  /// Log-normal about `expected`, one standard deviation a factor of `spread`. REQUIRES: spread
  /// > 1.
  VisibilityBelief(Meters expected, double spread);

  /// What a session said of its water, from its `estimate()`.
  [[nodiscard]] static VisibilityBelief Of(const WaterVisibility& estimate);

  /// The visibilities that are considered [m].
  [[nodiscard]] static const PerVisibility& Grid();
  /// Takes ln P(what was seen | visibility), up to a constant. No single call makes any visibility
  /// less likely than the best by more than a factor of exp(`most`): nothing that happens at one
  /// place is proof of what the whole water is like.
  void Add(const PerVisibility& log_likelihood, double most);

  /// Chances of the visibilities of Grid(); sum to one.
  [[nodiscard]] const PerVisibility& chances() const { return chances_; }
  /// Mean over the belief.
  [[nodiscard]] double Expect(const PerVisibility& value) const { return (chances_ * value).sum(); }
  /// Median-like centre (mean in the logarithm) and spread, the detector's own included.
  [[nodiscard]] WaterVisibility estimate() const;

 private:
  PerVisibility chances_;
};

}  // namespace limpet
