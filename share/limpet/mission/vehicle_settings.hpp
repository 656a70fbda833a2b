// SPDX-License-Identifier: MIT
// What blocks of a mission take from the file of the vehicle that flies it.
#pragma once

#include "limpet/mission/fact_files.hpp"

namespace limpet {

/// Name of the global of a mission that says which vehicle flies it.
inline constexpr const char* kVehicleFileGlobal = "VehicleFile";

[[nodiscard]] const FactFile& VehicleFacts();

}  // namespace limpet
