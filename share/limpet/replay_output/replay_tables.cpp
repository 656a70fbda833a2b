// SPDX-License-Identifier: MIT
#include "limpet/replay_output/replay_tables.hpp"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>
#include <sys/resource.h>

#include "limpet/core/require.hpp"
#include "limpet/core/statistics.hpp"

namespace limpet {

namespace {

std::string PoseCells(const SmoothedPose& pose) {
  const Pose& X = pose.X_WB;
  return fmt::format("{:.3f},{:.4f},{:.4f},{:.4f},{:.5f},{:.5f},{:.5f}", pose.t, X.p_WB.x(),
                     X.p_WB.y(), X.p_WB.z(), X.roll, X.pitch, X.yaw);
}

}  // namespace

std::string PosesCsv(const std::vector<SmoothedPose>& poses) {
  std::string text = "t,x,y,z,roll,pitch,yaw\n";
  for (const SmoothedPose& pose : poses)
    text += PoseCells(pose) + "\n";
  return text;
}

std::string SmoothedCsv(const std::vector<SmoothedPose>& poses,
                        const std::vector<Eigen::Vector4d>& sigmas) {
  LIMPET_REQUIRE(poses.size() == sigmas.size(), "sigmas of each pose");
  std::string text = "t,x,y,z,roll,pitch,yaw,sd_x,sd_y,sd_z,sd_yaw\n";
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Vector4d& sd = sigmas[i];
    text += fmt::format("{},{:.4g},{:.4g},{:.4g},{:.4g}\n", PoseCells(poses[i]), sd.x(), sd.y(),
                        sd.z(), sd.w());
  }
  return text;
}

std::string PlaceCovariancesCsv(const std::vector<SmoothedPose>& poses,
                                const std::vector<Eigen::Matrix3d>& covariances_W) {
  LIMPET_REQUIRE(poses.size() == covariances_W.size(), "a covariance of each pose");
  std::string text = "t,xx,xy,xz,yy,yz,zz\n";
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Matrix3d& C = covariances_W[i];
    text += fmt::format("{:.3f},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g}\n", poses[i].t, C(0, 0),
                        C(0, 1), C(0, 2), C(1, 1), C(1, 2), C(2, 2));
  }
  return text;
}

std::string StatesCsv(const std::vector<TimedStates>& all) {
  std::string text = "t,state,value,sd\n";
  for (const TimedStates& then : all) {
    for (const NamedState& state : then.states)
      text += fmt::format("{:.3f},{},{:.6g},{:.4g}\n", then.t, state.name, state.value, state.sd);
  }
  return text;
}

std::string MatchesCsv(const std::vector<Landmark>& landmarks) {
  std::string text = "landmark,former\n";
  for (const Landmark& landmark : landmarks) {
    text += fmt::format("{},{}\n", landmark.id, landmark.former.id.value_or(-1));
  }
  return text;
}

std::string AssociationsCsv(const std::vector<ReplayAssociation>& associations) {
  std::string text = "frame,det,landmark\n";
  for (const ReplayAssociation& a : associations) {
    text += fmt::format("{},{},{}\n", a.frame, a.detection, a.landmark.value_or(-1));
  }
  return text;
}

std::string TimingJson(std::vector<double> updates_s, double total_s) {
  std::ranges::sort(updates_s);
  const auto quantile_ms = [&updates_s](double share) {
    return 1e3 * QuantileOfSorted(updates_s, share);
  };
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return fmt::format(
      "{{\"updates\": {}, \"median_ms\": {:.4f}, \"p99_ms\": {:.4f}, \"max_ms\": {:.4f}, "
      "\"total_s\": {:.4f}, \"peak_rss_mb\": {:.1f}}}\n",
      updates_s.size(), quantile_ms(0.5), quantile_ms(0.99), quantile_ms(1.0), total_s,
      static_cast<double>(usage.ru_maxrss) / 1024.0);
}

}  // namespace limpet
