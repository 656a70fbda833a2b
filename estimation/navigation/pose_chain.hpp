// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "estimation/navigation/depth_errors.hpp"
#include "estimation/navigation/fix_consensus.hpp"
#include "estimation/navigation/fix_error_belief.hpp"
#include "estimation/navigation/fix_worth.hpp"
#include "estimation/navigation/measurement_buffer.hpp"
#include "estimation/navigation/navigator_params.hpp"
#include "estimation/navigation/odometry_errors.hpp"
#include "estimation/smoothing/smoother.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/interval.hpp"

namespace limpet {

/// The chain of poses in the smoother: when it grows, and which terms a new pose gets. Dead
/// reckoning predicts from its newest pose, the head. `params`, `smoother` and `measurements` must
/// outlive it. Times in seconds.
class PoseChain {
 public:
  enum class FixUse { kTaken, kRefused, kLate };

  PoseChain(const NavigatorParams& params, Smoother& smoother, MeasurementBuffer& measurements);

  /// First pose: at a horizontal position in W [m], depth and attitude as measured then.
  void Begin(double t, const Eigen::Vector2d& p_W);
  /// The node at `t`: a new one, or the head if it is that old.
  int NodeAt(double t);
  FixUse AddFix(const PositionFix& of_antenna);

  /// True once a fix was believed: places do not count from the start alone.
  [[nodiscard]] bool has_fix() const { return has_fix_; }
  [[nodiscard]] bool has_begun() const { return !times_.empty(); }
  [[nodiscard]] int size() const { return static_cast<int>(times_.size()); }
  [[nodiscard]] double TimeOf(int node) const { return times_[static_cast<std::size_t>(node)]; }
  [[nodiscard]] double head_time() const { return times_.back(); }
  [[nodiscard]] NavVector Head() const { return smoother_.PoseAt(size() - 1); }
  /// True if `t` is older than the head, beyond what counts as one time.
  [[nodiscard]] bool IsTooLate(double t) const;
  /// When the next pose is due, whatever is measured.
  [[nodiscard]] double NextKeyframe() const;

  /// Motion from the head to `t`, slow errors taken out.
  [[nodiscard]] OdometryStep StepTo(double t) const;
  /// Roll and pitch [rad].
  struct Tilt {
    double roll = 0.0, pitch = 0.0;
  };
  /// The head after a step, with the tilt that is measured then.
  [[nodiscard]] NavVector After(const OdometryStep& step, const Tilt& tilt) const;
  [[nodiscard]] NavVector Predict(double t) const;
  /// Bottom track alone from the first pose on.
  [[nodiscard]] Pose DeadReckoned(double t) const;
  [[nodiscard]] const OdometryErrors& errors() const { return errors_; }
  [[nodiscard]] const DepthErrors& depth_errors() const { return depth_errors_; }
  [[nodiscard]] const FixErrorBelief& fix_error() const { return fix_error_; }

 private:
  /// A fix that is in the smoother.
  struct TakenFix {
    HeldFix held;
    TermId term{};
  };
  /// Fixes of one stay at the surface.
  struct Stay {
    FixRow row{};
    std::vector<TakenFix> taken{};
    double scale = 1.0;           ///< sigma of what wanders, over what they state
    double doubt_variance = 0.0;  ///< because other fixes may be the right ones [m^2]
  };
  void AddTilt(int node, double t);
  /// A fix of the antenna as one of the body's origin, turned as the node is now known to be.
  [[nodiscard]] PositionFix OfBody(PositionFix fix, int node) const;
  /// The mean of the depths in `span` [s], carried to its end.
  void AddDepth(int node, const Interval& span);

  /// True if it neither climbs nor sinks: one on its way may have its antenna out of the water,
  /// too.
  [[nodiscard]] bool IsLevel(double t) const;
  /// Dead reckoning has the vehicle at `reckoned_D` [m].
  void BeginStay(const PositionFix& first, const Eigen::Vector2d& reckoned_D);
  /// What the fixes that are believed now say of their error.
  void LearnFixError(const FixConsensus::Verdict& verdict);
  void LearnFrom(const HeldFix& held, double since);
  /// How sure fixes are has changed since those of this stay were taken.
  [[nodiscard]] bool WeighAnew();
  /// All of this stay that are believed in place of those that were.
  void RetakeFixes();
  /// Those of earlier stays, where they are believed otherwise than when they were taken.
  void ReweighEarlierStays();
  /// What fixes before it are worth changes with that.
  void TakeFix(const HeldFix& held);
  void NoteFixes();
  [[nodiscard]] TermId AddFixTerm(const Stay& stay, std::size_t number);

  const NavigatorParams& params_;
  Smoother& smoother_;
  MeasurementBuffer& measurements_;
  OdometryErrors errors_;
  DepthErrors depth_errors_;
  std::vector<double> times_;  ///< of the nodes
  PersistenceGate depth_gate_;
  FixConsensus consensus_;
  FixErrorBelief fix_error_;
  double fix_scale_ = 1.0;  ///< sigma of what wanders of fixes, over what they state
  Stay stay_;               ///< the latest
  std::vector<Stay> earlier_stays_;
  std::optional<double> last_fix_t_, before_stay_t_;
  bool has_fix_ = false;
  int refused_before_ = 0;                          ///< fixes, before this stay
  Eigen::Vector3d p_WD_ = Eigen::Vector3d::Zero();  ///< of the track's frame at the start, in W
};

}  // namespace limpet
