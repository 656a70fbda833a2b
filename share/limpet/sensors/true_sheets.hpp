// SPDX-License-Identifier: MIT
// Data sheets as they would be if they were true: what a simulated sensor is built of.
#pragma once

#include "limpet/simulation/sheet_error.hpp"
#include "limpet/vehicle/sensor_sheets.hpp"

namespace limpet {

[[nodiscard]] ImuSheet TrueSheet(ImuSheet sheet, const SheetErrorParams& error);
[[nodiscard]] FogSheet TrueSheet(FogSheet sheet, const SheetErrorParams& error);
[[nodiscard]] DvlSheet TrueSheet(DvlSheet sheet, const SheetErrorParams& error);
[[nodiscard]] DepthSheet TrueSheet(DepthSheet sheet, const SheetErrorParams& error);

}  // namespace limpet
