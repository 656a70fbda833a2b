// SPDX-License-Identifier: MIT
#include "estimation/association/camera_mount.hpp"

#include <algorithm>

#include "estimation/smoothing/factors/border_prior_factor.hpp"

namespace limpet {
namespace {

constexpr double kLeastSigma = 1e-6;  // of what is not in doubt: a prior needs one

}  // namespace

void CameraMount::Begin(bool is_needed) {
  if (slots_ || smoother_ == nullptr || !(is_needed || is_in_doubt())) return;
  const auto add = [this](const Eigen::Vector3d& sigma) {
    const int slot = smoother_->AddCameraErrors(Eigen::Vector3d::Zero());
    const Eigen::Matrix3d covariance =
        sigma.cwiseMax(kLeastSigma).cwiseAbs2().asDiagonal().toDenseMatrix();
    smoother_->AddBorderTerm(
        slot, Term::OnBorder(BorderPriorFactor(Eigen::Vector3d::Zero(), covariance), slot));
    return slot;
  };
  const int tilt = add(Eigen::Vector3d::Constant(params_.tilt_sigma));
  const int shift = add({params_.lever_sigma, params_.lever_sigma, params_.delay_sigma});
  slots_ = Slots{tilt, shift};
}

CameraErrors CameraMount::errors() const {
  if (!slots_) return {};
  return {.tilt_B = smoother_->BorderAt((*slots_)[0]),
          .lever_and_delay = smoother_->BorderAt((*slots_)[1])};
}

CameraModel CameraMount::At(const BodyMotion& motion) const {
  return slots_ ? WithErrors(camera_, errors(), motion) : camera_;
}

}  // namespace limpet
