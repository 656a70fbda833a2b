// SPDX-License-Identifier: MIT
#include "limpet/sensors/dvl_model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "limpet/sensors/true_sheets.hpp"

namespace limpet {
namespace {

using Eigen::Vector3d;

constexpr std::array kAzimuths_deg = {45.0, 135.0, 225.0, 315.0};

}  // namespace

DvlModel::DvlModel(const Params& params, SoundScene scene, Random random, Random errors)
    : params_(params),
      true_(TrueSheet(params.sheet, params.error.sheet)),
      scene_(std::move(scene)),
      random_(random),
      p_BD_(params.sheet.p_BD + params.error.mounting.off_B),
      faults_(random_.Bits(), "faults"),
      dropouts_({.per_second = params.dropout_per_min / 60.0,
                 .shortest = Seconds(params.dropout_shortest_s),
                 .longest = Seconds(params.dropout_longest_s)}),
      beam_error_(params.error.beams, params.sheet.beam_angle.value(),
                  Random(errors.Bits(), "beams")),
      bursts_(params.error.bursts, Random(errors.Bits(), "bursts")) {
  const DvlSheet& sheet = true_;
  const Eigen::Matrix3d R_mounting = params.error.mounting.rotation();
  const double tilt = sheet.beam_angle.value(), yaw = sheet.yaw.value();
  std::ranges::transform(kAzimuths_deg, beams_B_.begin(), [&](double azimuth_deg) {
    const double azimuth = RadiansFromDegrees(azimuth_deg) + yaw;
    return Vector3d(R_mounting * Vector3d(std::sin(tilt) * std::cos(azimuth),
                                          std::sin(tilt) * std::sin(azimuth), std::cos(tilt)));
  });
  const double scale = 1.0 + random_.Normal(sheet.scale_sigma);
  const double misalignment = random_.Normal(sheet.misalignment_sigma.value());
  R_DB_ = RotationFromRollPitchYaw(0.0, 0.0, -yaw) * R_mounting.transpose();
  distortion_ = scale * RotationFromRollPitchYaw(0.0, 0.0, misalignment);
  for (double& part : bias_)
    part = random_.Normal(sheet.bias_mps);
}

DvlModel::Ranges DvlModel::MeasureRanges(const Pose& X_WB) {
  const Eigen::Matrix3d R_WB = RotationOf(X_WB);
  const Vector3d origin_W = X_WB.p_WB + R_WB * p_BD_;
  const double max_range =
      params_.sheet.greatest_altitude.value() / std::cos(params_.sheet.beam_angle.value());
  Ranges ranges;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const double unit = random_.Normal(1.0);  // drawn even when nothing is met: noise stays aligned
    ranges[i] = scene_.Range(origin_W, R_WB * beams_B_[i], max_range);
    if (ranges[i]) {
      *ranges[i] += unit * (true_.range_noise_m + true_.range_noise_share * *ranges[i]);
    }
  }
  return ranges;
}

std::optional<double> DvlModel::Altitude(const Ranges& ranges, const Pose& X_WB) const {
  const Eigen::Matrix3d R_WB = RotationOf(X_WB);
  std::vector<double> heights;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (ranges[i]) heights.push_back(*ranges[i] * (R_WB * beams_B_[i]).z());
  }
  if (heights.size() < 3) return std::nullopt;
  std::ranges::sort(heights);
  // The middle beams: one that meets an object must not lift the seabed.
  return 0.5 * (heights[(heights.size() - 1) / 2] + heights[heights.size() / 2]);
}

Vector3d DvlModel::MeasureVelocity(const SimTruth& truth) {
  const Vector3d omega(truth.p, truth.q, truth.r);
  const Vector3d at_lever = Vector3d(truth.u, truth.v, truth.w) + omega.cross(p_BD_);
  Vector3d noise;
  for (double& part : noise)
    part = random_.Normal(true_.noise_mps);
  noise.z() *= params_.sheet.vertical_noise_mps / params_.sheet.noise_mps;
  Vector3d velocity = distortion_ * (R_DB_ * at_lever) + bias_ + noise;
  if (faults_.Chance(params_.outlier_share)) {
    for (double& part : velocity)
      part += faults_.Normal(params_.outlier_sigma_mps);
  }
  return velocity;
}

BeamError::Slopes DvlModel::SlopesAt(const Pose& X_WB, const Ranges& ranges) const {
  BeamError::Slopes slopes{};
  const Eigen::Matrix3d R_WB = RotationOf(X_WB);
  const Vector3d origin_W = X_WB.p_WB + R_WB * p_BD_;
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    if (ranges[i]) slopes[i] = scene_.SlopeAlong(origin_W, R_WB * beams_B_[i], *ranges[i]);
  }
  return slopes;
}

std::optional<DvlSample> DvlModel::Sample(const SimTruth& truth, Seconds now) {
  DvlSample sample;
  sample.sd_horizontal = params_.sheet.noise_mps;
  sample.sd_vertical = params_.sheet.vertical_noise_mps;
  Ranges ranges = MeasureRanges(truth.pose());
  Vector3d velocity = MeasureVelocity(truth);
  if (!params_.error.beams.is_off()) {
    const BeamError::Lost lost = beam_error_.DrawLost();
    const auto said = beam_error_.Velocity(velocity, SlopesAt(truth.pose(), ranges), lost);
    velocity = said.value_or(velocity);  // without, the altitude says below that there is no lock
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      if (lost[i]) ranges[i].reset();
    }
  }
  velocity += bursts_.At(now);
  const std::optional<double> altitude = Altitude(ranges, truth.pose());
  const bool is_in_dropout = dropouts_.Contain(now, faults_);
  if (is_in_dropout || !altitude || *altitude < params_.sheet.least_altitude.value() ||
      *altitude > params_.sheet.greatest_altitude.value()) {
    return sample;
  }
  sample.has_lock = true;
  sample.u = velocity.x(), sample.v = velocity.y(), sample.w = velocity.z();
  sample.altitude = altitude;
  sample.b1 = ranges[0], sample.b2 = ranges[1], sample.b3 = ranges[2], sample.b4 = ranges[3];
  return sample;
}

}  // namespace limpet
