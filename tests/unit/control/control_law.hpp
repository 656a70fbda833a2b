// SPDX-License-Identifier: MIT
// What tests of single control laws share.
#pragma once

#include "limpet/vehicle/hydrodynamics.hpp"

namespace limpet {

inline constexpr double kLawStep = 0.1;  // [s]

inline Hydrodynamics DefaultHydrodynamics() { return DeriveHydrodynamics(VehicleParams{}); }

}  // namespace limpet
