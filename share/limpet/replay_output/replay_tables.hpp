// SPDX-License-Identifier: MIT
// A replayed stream as tables; landmarks are written by estimation/replay, which reads them again.
#pragma once

#include <string>
#include <vector>

#include "estimation/replay/replay.hpp"

namespace limpet {

/// `t,x,y,z,roll,pitch,yaw` [s, m, rad], NED.
[[nodiscard]] std::string PosesCsv(const std::vector<SmoothedPose>& poses);
/// A table as of PosesCsv, with the 1-sigmas of north, east, down [m] and heading [rad] of each.
[[nodiscard]] std::string SmoothedCsv(const std::vector<SmoothedPose>& poses,
                                      const std::vector<Eigen::Vector4d>& sigmas);
/// `t,xx,xy,xz,yy,yz,zz` [s, m^2], NED: how surely each place of `poses` was known. REQUIRES: as
/// many covariances.
[[nodiscard]] std::string PlaceCovariancesCsv(const std::vector<SmoothedPose>& poses,
                                              const std::vector<Eigen::Matrix3d>& covariances_W);
/// `t,state,value,sd` [s; m/s, rad, m, s]: what is estimated beside pose and objects, at each time.
[[nodiscard]] std::string StatesCsv(const std::vector<TimedStates>& all);
/// `landmark,former`: -1 for one that no earlier session knew.
[[nodiscard]] std::string MatchesCsv(const std::vector<Landmark>& landmarks);
/// `frame,det,landmark`
[[nodiscard]] std::string AssociationsCsv(const std::vector<ReplayAssociation>& associations);
/// How long updates took, each and together [s], and the most memory that this process has had.
[[nodiscard]] std::string TimingJson(std::vector<double> updates_s, double total_s);

}  // namespace limpet
