// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Core>

#include "estimation/navigation/sample_period.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// The newest velocities of the DVL in body axes [m/s], as a track goes by them: measured, or what
/// bridged them in a dropout. Between two of them it is their linear interpolation; the last one is
/// held.
class DvlVelocities {
 public:
  /// `usual_period`: until the DVL's own is known.
  explicit DvlVelocities(Seconds usual_period) : period_(usual_period.value()) {}

  [[nodiscard]] bool IsNews(double t) const { return !rows_ || t > rows_->newest.t; }
  /// True if nothing has come for so long before `t` that the DVL had no lock meanwhile.
  [[nodiscard]] bool WasSilentBefore(double t) const {
    return believed_t_ && t - rows_->newest.t > LongestPause();
  }
  void NotePeriod(double t) { period_.Note(t); }
  /// REQUIRES: IsNews(t). Nothing measured: the last one stands in for it.
  void Add(double t, const std::optional<Eigen::Vector3d>& v_B);
  /// The newest one was measured, and is true.
  void BelieveNewest() { believed_t_ = rows_->newest.t; }
  /// What stands in for the newest one.
  void BridgeNewest(const Eigen::Vector3d& v_B) { rows_->newest.v_B = v_B; }

  [[nodiscard]] bool empty() const { return !rows_; }
  /// Zero before the first one.
  [[nodiscard]] Eigen::Vector3d At(double t) const;
  /// REQUIRES: !empty().
  [[nodiscard]] double newest_time() const { return rows_->newest.t; }
  /// Time up to which the newest velocity changed nothing [s]. REQUIRES: !empty().
  [[nodiscard]] double previous_time() const { return rows_->before.t; }
  /// Time of the last velocity that was measured and believed [s].
  [[nodiscard]] const std::optional<double>& believed_time() const { return believed_t_; }

  /// Seconds between samples.
  [[nodiscard]] double period() const { return period_.value(); }
  /// Seconds between velocities that are no dropout: half a second, or more of a DVL that pings
  /// more slowly.
  [[nodiscard]] double LongestPause() const;
  /// Seconds since the last believed one, if that is long enough to be a dropout at `t`.
  [[nodiscard]] std::optional<double> DropoutAge(double t) const;

 private:
  struct Row {
    double t = 0.0;
    Eigen::Vector3d v_B = Eigen::Vector3d::Zero();
  };
  struct Rows {
    Row before;  ///< the newest once more until one is true
    Row newest;
  };
  std::optional<Rows> rows_;
  std::optional<double> believed_t_;
  SamplePeriod period_;
};

}  // namespace limpet
