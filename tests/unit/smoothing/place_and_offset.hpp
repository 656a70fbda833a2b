// SPDX-License-Identifier: MIT
// A place, and what acoustic measurements of it are off by.
#pragma once

#include "estimation/smoothing/nav_vector.hpp"

namespace limpet {

inline const NavVector kPlace = (NavVector() << 3.0, -4.0, 5.0, 0.7, 0.0, 0.0).finished();
inline const Eigen::Vector3d kOff(0.4, -0.3, 0.2);

}  // namespace limpet
