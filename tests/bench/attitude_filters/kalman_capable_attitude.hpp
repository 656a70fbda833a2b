// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <mrpt/bayes/CKalmanFilterCapable.h>

#include "estimation/attitude/attitude_filter.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/gravity.hpp"

namespace limpet {

/// Roll and pitch of AttitudeFilter's model on MRPT's Kalman filter: state roll, pitch and the
/// biases of p and q; action the rates; observation the two tilts of the specific force.
class KalmanCapableAttitude final : public mrpt::bayes::CKalmanFilterCapable<4, 2, 0, 3> {
 public:
  KalmanCapableAttitude(const AttitudeParams& params, mrpt::bayes::TKFMethod method)
      : params_(params) {
    KF_options.method = method;
    m_timLogger.disable();
    m_xkk.setZero(4);
    m_pkk.setZero(4, 4);
  }

  void AddFogRate(double rate) { fog_rate_ = rate; }
  void SetBodyVelocity(const Eigen::Vector3d& v_WB_B) { v_WB_B_ = v_WB_B; }

  void AddInertial(const InertialInput& input) {
    force_ = input.force_B;
    rate_ = {input.rate_B.x(), input.rate_B.y(), fog_rate_};
    if (t_ < 0.0) {
      const Eigen::Vector2d tilt = TiltOf(force_);
      const double tilt_sd = params_.tilt_sigma.value(), bias_sd = params_.gyro_bias_sigma.value();
      m_xkk[0] = tilt.x(), m_xkk[1] = tilt.y();
      for (std::size_t i = 0; i < 4; ++i)
        m_pkk(i, i) = i < 2 ? tilt_sd * tilt_sd : bias_sd * bias_sd;
    } else {
      dt_ = input.t - t_;
      runOneKalmanIteration();
    }
    t_ = input.t;
  }
  [[nodiscard]] double roll() const { return m_xkk[0]; }
  [[nodiscard]] double pitch() const { return m_xkk[1]; }

 protected:
  void OnGetAction(KFArray_ACT& u) const override {
    for (int i = 0; i < 3; ++i)
      u[i] = rate_(i);
  }
  void OnTransitionModel(const KFArray_ACT& u, KFArray_VEH& x, bool& /*skips*/) const override {
    const double cr = std::cos(x[0]), sr = std::sin(x[0]);
    const double cp = std::max(std::cos(x[1]), 0.05), tp = std::sin(x[1]) / cp;
    const double p = u[0] - x[2], q = u[1] - x[3], r = u[2];
    x[0] = WrapAngle(x[0] + dt_ * (p + tp * (q * sr + r * cr)));
    x[1] += dt_ * (q * cr - r * sr);
  }
  void OnTransitionJacobian(KFMatrix_VxV& F) const override {
    const double cr = std::cos(m_xkk[0]), sr = std::sin(m_xkk[0]);
    const double cp = std::max(std::cos(m_xkk[1]), 0.05), tp = std::sin(m_xkk[1]) / cp;
    const double q = rate_.y() - m_xkk[3], r = rate_.z();
    F.setIdentity();
    F(0, 0) += dt_ * tp * (q * cr - r * sr);
    F(0, 1) = dt_ * (q * sr + r * cr) / (cp * cp);
    F(0, 2) = -dt_;
    F(0, 3) = -dt_ * tp * sr;
    F(1, 0) = -dt_ * (q * sr + r * cr);
    F(1, 3) = -dt_ * cr;
  }
  void OnTransitionNoise(KFMatrix_VxV& Q) const override {
    const double noise = params_.gyro_noise.value() * params_.gyro_noise.value() * dt_;
    const double walk = params_.gyro_bias_walk.value() * params_.gyro_bias_walk.value() * dt_;
    Q.setZero();
    Q(0, 0) = Q(1, 1) = noise, Q(2, 2) = Q(3, 3) = walk;
  }
  void OnGetObservationNoise(KFMatrix_OxO& R) const override {
    const double sigma = params_.tilt_sigma.value();
    R.setZero();
    R(0, 0) = R(1, 1) = sigma * sigma / std::clamp(dt_, 1e-3, 1.0);
  }
  void OnGetObservationsAndDataAssociation(vector_KFArray_OBS& z, std::vector<int>& association,
                                           const vector_KFArray_OBS& /*predictions*/,
                                           const KFMatrix& /*S*/,
                                           const std::vector<size_t>& /*landmarks*/,
                                           const KFMatrix_OxO& /*R*/) override {
    association.clear();
    z.clear();
    const Eigen::Vector3d rate(rate_.x() - m_xkk[2], rate_.y() - m_xkk[3], rate_.z());
    const Eigen::Vector3d force = force_ - rate.cross(v_WB_B_);
    if (std::abs(force.norm() - kGravity) > params_.force_gate) return;
    const Eigen::Vector2d tilt = TiltOf(force);
    z.resize(1);
    z[0][0] = tilt.x(), z[0][1] = tilt.y();
  }
  void OnObservationModel(const std::vector<size_t>& /*landmarks*/,
                          vector_KFArray_OBS& predictions) const override {
    predictions.resize(1);
    predictions[0][0] = m_xkk[0], predictions[0][1] = m_xkk[1];
  }
  void OnObservationJacobians(size_t /*landmark*/, KFMatrix_OxV& Hx,
                              KFMatrix_OxF& /*Hy*/) const override {
    Hx.setZero();
    Hx(0, 0) = Hx(1, 1) = 1.0;
  }
  void OnSubstractObservationVectors(KFArray_OBS& a, const KFArray_OBS& b) const override {
    a[0] = WrapAngle(a[0] - b[0]);
    a[1] -= b[1];
  }
  void OnNormalizeStateVector() override { m_xkk[0] = WrapAngle(m_xkk[0]); }

 private:
  static Eigen::Vector2d TiltOf(const Eigen::Vector3d& force) {
    return {std::atan2(-force.y(), -force.z()),
            std::atan2(force.x(), std::hypot(force.y(), force.z()))};
  }
  AttitudeParams params_;
  Eigen::Vector3d force_ = Eigen::Vector3d::Zero(), rate_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d v_WB_B_ = Eigen::Vector3d::Zero();
  double fog_rate_ = 0.0, t_ = -1.0, dt_ = 0.0;
};

}  // namespace limpet
