// SPDX-License-Identifier: MIT
// What `limpet nav` keeps of a session's objects, for the next one.
//   landmarks.csv             id,x,y,z,sd_x,sd_y,sd_z,class,looks
//   landmarks_covariance.csv  id,axis, then the row of the joint covariance up to the diagonal
//   [m^2]
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "estimation/navigation/navigator.hpp"
#include "estimation/replay/sensor_stream.hpp"
#include "limpet/core/expected.hpp"

namespace limpet {

[[nodiscard]] std::string LandmarksCsv(const std::vector<Landmark>& landmarks);
/// `covariance`: joint, three rows per landmark.
[[nodiscard]] std::string LandmarkCovarianceCsv(const std::vector<Landmark>& landmarks,
                                                const Eigen::MatrixXd& covariance);

/// The error names file and line.
[[nodiscard]] Expected<FormerSession> ParseFormerLandmarks(const StreamFile& landmarks,
                                                           const StreamFile& covariance);
/// Both files of a folder.
[[nodiscard]] Expected<FormerSession> LoadFormerLandmarks(const std::filesystem::path& folder);

}  // namespace limpet
