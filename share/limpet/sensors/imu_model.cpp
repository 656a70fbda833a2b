// SPDX-License-Identifier: MIT
#include "limpet/sensors/imu_model.hpp"

#include "limpet/core/frames.hpp"

namespace limpet {

ImuModel::ImuModel(const Params& params, Random random, Random errors)
    : params_(params),
      random_(random),
      accel_bias_(Noise(params.sheet.force_bias_mps2)),
      gyro_bias_(Noise(params.sheet.gyro_bias_radps)),
      heading_offset_(random_.Normal(params.sheet.heading_sigma.value())),
      heading_slow_(params.heading_slow_sigma_rad, params.heading_slow),
      compass_(params.compass, errors),
      gyro_(params.gyro) {}

Eigen::Vector3d ImuModel::Noise(double sigma) {
  Eigen::Vector3d noise;  // one statement each: the order of arguments is not defined
  for (double& part : noise)
    part = random_.Normal(sigma);
  return noise;
}

std::optional<ImuSample> ImuModel::Sample(const SimTruth& truth, Seconds now) {
  const Eigen::Vector3d f = Eigen::Vector3d(truth.fx, truth.fy, truth.fz) + accel_bias_ +
                            Noise(params_.sheet.force_noise_mps2);
  Eigen::Vector3d w = Eigen::Vector3d(truth.p, truth.q, truth.r) + gyro_bias_ +
                      Noise(params_.sheet.gyro_noise_radps);
  w.z() += gyro_.Of(truth.r, now);
  const double slow = heading_slow_.Sample(now, random_);
  const double heading = truth.yaw + heading_offset_ + slow +
                         random_.Normal(params_.heading_noise_rad) + compass_.Of(truth.yaw);
  return ImuSample{.fx = f.x(),
                   .fy = f.y(),
                   .fz = f.z(),
                   .p = w.x(),
                   .q = w.y(),
                   .r = w.z(),
                   .heading = WrapAngle(heading)};
}

}  // namespace limpet
