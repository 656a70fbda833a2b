// SPDX-License-Identifier: MIT
#include "estimation/navigation/navigator_estimate.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "estimation/smoothing/mrpt_poses.hpp"
#include "limpet/core/require.hpp"

namespace limpet {
namespace {

constexpr double kDepthPause = 2.0;  // [s] without depth or velocity in which nothing sinks

/// What nobody has measured since the attitude fell silent `seconds` ago; of the depth also what
/// neither pressure nor velocity has.
void AddSilence(double t, double seconds, const PoseChain& chain,
                const MeasurementBuffer& measurements, NavCovariance& covariance) {
  const OdometryParams& odometry = measurements.track().params();
  const double depth_age = t - measurements.depths().last_time().value_or(chain.head_time());
  const double sinking =
      std::min(depth_age, measurements.track().DropoutAge(t).value_or(0.0)) - kDepthPause;
  const SilenceVariance silence = VarianceOfSilence(odometry, seconds);
  covariance(kNavX, kNavX) += silence.horizontal;
  covariance(kNavY, kNavY) += silence.horizontal;
  covariance(kNavZ, kNavZ) +=
      std::max(silence.vertical, VarianceOfSilence(odometry, sinking).vertical);
  covariance(kNavYaw, kNavYaw) += silence.yaw;
}

/// That the vehicle may have stopped since there was a velocity, and nothing told. Of what is
/// published alone: the chain goes by what is likely, and the dropout's end tells what was.
void AddUntoldStop(const TrackPose& track, double yaw, NavCovariance& covariance) {
  const Eigen::Matrix2d R_WD = Eigen::Rotation2Dd(yaw - track.X_DB.yaw).toRotationMatrix();
  covariance.topLeftCorner<2, 2>() += R_WD * track.stop_covariance_D * R_WD.transpose();
}

/// Covariance of the levelled head, then of the step: MRPT carries it through the composition.
NavCovariance CovarianceAfter(const OdometryStep& step, NavVector head, const Smoother& smoother) {
  head.tail<2>().setZero();
  NavVector motion = NavVector::Zero();
  motion.head<4>() = step.motion;
  NavCovariance motion_covariance = NavCovariance::Zero();
  motion_covariance.diagonal().head<4>() = step.variance;
  auto pdf = MrptPosePdf(head, smoother.Covariance({}));
  pdf += MrptPosePdf(motion, motion_covariance);
  return CovarianceOf(pdf);
}

}  // namespace

NavigatorEstimate EstimateAt(double t, const PoseChain& chain, const Smoother& smoother,
                             const MeasurementBuffer& measurements) {
  LIMPET_REQUIRE(chain.has_begun(), "no pose yet");
  const TrackPose track = measurements.track().At(t);
  const OdometryStep step = chain.StepTo(t);
  NavCovariance covariance = CovarianceAfter(step, chain.Head(), smoother);
  AddSilence(t, t - track.t, chain, measurements, covariance);
  const Pose X_WB = PoseOf(chain.After(step, {.roll = track.X_DB.roll, .pitch = track.X_DB.pitch}));
  AddUntoldStop(track, X_WB.yaw, covariance);
  NavigatorEstimate estimate{.t = t,
                             .X_WB = X_WB,
                             .v_B = track.v_B,
                             .yaw_rate = track.yaw_rate,
                             .altitude = measurements.AltitudeAt(t),
                             .velocity_age = measurements.track().DropoutAge(t)};
  estimate.covariance_p_W = covariance.topLeftCorner<3, 3>();
  estimate.sd_p_W = covariance.diagonal().head<3>().cwiseMax(0.0).cwiseSqrt();
  estimate.sd_yaw = std::sqrt(std::max(covariance(kNavYaw, kNavYaw), 0.0));
  return estimate;
}

}  // namespace limpet
