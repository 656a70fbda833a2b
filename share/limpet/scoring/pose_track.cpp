// SPDX-License-Identifier: MIT
#include "limpet/scoring/pose_track.hpp"

#include <algorithm>
#include <cmath>

namespace limpet {

void PoseTrack::Add(Seconds time, const Pose& X_WB) {
  if (!empty() && time.value() <= time_.back()) return;
  const Eigen::Vector3d& p = X_WB.p_WB;
  path_.push_back(empty() ? 0.0 : path_.back() + (p - position(size() - 1)).norm());
  time_.push_back(time.value());
  north_.push_back(p.x());
  east_.push_back(p.y());
  down_.push_back(p.z());
  roll_.push_back(X_WB.roll);
  pitch_.push_back(X_WB.pitch);
  yaw_.push_back(X_WB.yaw);
}

std::size_t PoseTrack::IndexBefore(double time) const {
  const auto after = std::upper_bound(time_.begin(), time_.end(), time);
  return static_cast<std::size_t>(after - time_.begin()) - 1;
}

std::optional<Pose> PoseTrack::At(double time) const {
  // Logged stamps carry a rounding of 1e-5 s, so the ends are a little soft.
  constexpr double kSlack = 1e-3;
  if (empty() || time < time_.front() - kSlack || time > time_.back() + kSlack) return std::nullopt;
  const double t = std::clamp(time, time_.front(), time_.back());
  const std::size_t i = std::min(IndexBefore(t), size() - 1);
  const std::size_t j = std::min(i + 1, size() - 1);
  const double f = j == i ? 0.0 : (t - time_[i]) / (time_[j] - time_[i]);
  const auto turn = [f](double a, double b) { return WrapAngle(a + f * WrapAngle(b - a)); };
  return Pose{(1.0 - f) * position(i) + f * position(j), turn(roll_[i], roll_[j]),
              turn(pitch_[i], pitch_[j]), turn(yaw_[i], yaw_[j])};
}

double PoseTrack::PathAt(double time) const {
  if (empty() || time <= time_.front()) return 0.0;
  if (time >= time_.back()) return path_.back();
  const std::size_t i = IndexBefore(time);
  const double f = (time - time_[i]) / (time_[i + 1] - time_[i]);
  return path_[i] + f * (path_[i + 1] - path_[i]);
}

}  // namespace limpet
