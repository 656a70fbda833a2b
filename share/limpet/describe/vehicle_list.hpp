// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace limpet {

/// The keys of a vehicle's file, section by section, as its reader declares them.
[[nodiscard]] std::string VehicleKeysText();
[[nodiscard]] std::string VehicleKeysJson();
/// The page docs/vehicle-file.md.
[[nodiscard]] std::string VehicleKeysMarkdown();

}  // namespace limpet
