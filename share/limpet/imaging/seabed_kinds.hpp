// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

#include "limpet/imaging/seabed_ground.hpp"

namespace limpet {

/// A tile of the seabed `kind` of ImageParams::Seabed: sand with ripples, gravel, rock with growth,
/// sea-grass, or sand with banks of the others. Equal seeds give equal ground.
[[nodiscard]] SeabedGround MakeSeabed(std::string_view kind, std::uint64_t seed);

}  // namespace limpet
