// SPDX-License-Identifier: MIT
// Vectors and matrices whose names do not say in which frame they are.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/layers/layers.hpp"

namespace limpet::layers {

/// The letters of the frames that docs/frames-and-units.md names: of `**Body B**` the `B`.
[[nodiscard]] std::string ReadFrameLetters(std::string_view markdown);

/// One complaint per public data member of a header of the product that is an Eigen vector or
/// matrix of two or three rows, by that or by another name that a header gives it, or holds some,
/// and whose name ends neither in one or more of `letters` nor in `px`: `path: Type::name`. A
/// Jacobian `J_x` has no frame of its own.
[[nodiscard]] std::vector<std::string> MembersWithoutFrame(const std::vector<SourceFile>& files,
                                                           const std::string& letters);

/// The like of parameters of functions in headers: `path: Function(name)`. A PlanePoint is in W by
/// its type.
[[nodiscard]] std::vector<std::string> ParametersWithoutFrame(const std::vector<SourceFile>& files,
                                                              const std::string& letters);

}  // namespace limpet::layers
