// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <optional>

#include <Eigen/Core>

#include "estimation/navigation/navigator_params.hpp"
#include "estimation/smoothing/smoother.hpp"
#include "limpet/core/interval.hpp"

namespace limpet {

/// What dead reckoning is off for longer than a step, as border variables of the smoother: scale,
/// misalignment [rad] and bias of the yaw rate [rad/s], anew from time to time; the gyro's scale
/// and where the DVL is [m], for good; and in a dropout of the DVL what current and speed through
/// the water are off [m/s]. `params`, `smoother`, `track` must outlive it.
class OdometryErrors {
 public:
  OdometryErrors(const NavigatorParams& params, Smoother& smoother, const OdometryTrack& track)
      : params_(params), smoother_(smoother), track_(track) {}

  /// The chain begins at `t` [s].
  void Begin(double t);
  /// Term on the step from one node to the next, over the span between their times [s].
  [[nodiscard]] Term StepTerm(const Interval& span);
  /// Slot of scale, misalignment and bias of the yaw rate that hold now. REQUIRES: the chain has
  /// begun.
  [[nodiscard]] int slow_slot() const { return slow_->slot; }
  /// Slot of the gyro's scale and of where the DVL is ahead and to starboard, if these are
  /// estimated.
  [[nodiscard]] std::optional<int> mount_slot() const { return mount_; }
  /// The track's step over a span of times [s], errors as estimated now taken out. REQUIRES: the
  /// chain has begun.
  [[nodiscard]] OdometryStep Corrected(const Interval& span) const;

 private:
  /// A border variable that holds from a time [s] on.
  struct Variable {
    int slot;
    double since;
  };
  /// Scale, misalignment [rad], bias of the yaw rate [rad/s]. REQUIRES: the chain has begun.
  [[nodiscard]] Eigen::Vector3d Now() const { return smoother_.BorderAt(slow_->slot); }
  void BeginMount();
  [[nodiscard]] Eigen::Vector3d Mount() const {
    return mount_ ? smoother_.BorderAt(*mount_) : Eigen::Vector3d(Eigen::Vector3d::Zero());
  }
  /// Less the errors as estimated now.
  [[nodiscard]] Eigen::Vector4d Without(const OdometryStep& step) const;
  /// Slot of the slow errors that hold at `t`.
  int SlowAt(double t);
  /// Slot of what current and speed through the water are off in a dropout.
  int BridgeAt(double t);
  /// A part of a dropout in which current and speed are off by the same.
  struct Stretch {
    int slot;
    double since;  ///< [s]
    Conduct began;
    BridgeDrift drift{};  ///< to the next
  };
  void BeginStretch(const Stretch& stretch);
  [[nodiscard]] Term TermToNext(std::size_t stretch, const Eigen::Vector3d& besides) const;
  /// Out of the dropout: what the first velocities say of the bridge, once they have come.
  void ConcludeBridge(double t);
  void UseEnd(const BridgeEnd& end);
  /// Believes in changes of this variance more, from stretch to stretch and from its start on.
  void WidenBridge(const Eigen::Vector3d& variance);
  void EndBridge();

  const NavigatorParams& params_;
  Smoother& smoother_;
  const OdometryTrack& track_;
  std::optional<Variable> slow_;
  std::deque<Stretch> bridge_;  ///< the newest of this dropout
  /// Of the first of them; nothing once that is none of the newest.
  std::optional<Eigen::Matrix3d> bridge_start_;
  std::optional<int> mount_;
};

}  // namespace limpet
