// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include <Eigen/Core>

#include "limpet/core/expected.hpp"

namespace limpet {

/// The matrices of doubles in a MATLAB 5 file, compressed or not, by name. What else it holds is
/// left out; a damaged file is an error with the place in bytes.
[[nodiscard]] Expected<std::map<std::string, Eigen::MatrixXd>> ReadMatlabMatrices(
    const std::filesystem::path& file);

}  // namespace limpet
