// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

namespace limpet {

/// Writes a mission folder for a world drawn from `seed`: a site of 24 x 24 m with nine objects, of
/// which four stay, two go, two come and one is moved by 0.5 to 2 m; and water, altitude, objects'
/// size, clutter and sensors that differ from what the mission says by up to a factor of two and
/// more. The vehicle is told the altitude that it is to fly and a size that is off by up to 30 %;
/// of all else it has its defaults. scenario.yaml is of both sessions; scenario_change.yaml has
/// another water, for a change session in water of its own.
void WriteDrawnWorld(std::uint64_t seed, const std::filesystem::path& folder);

}  // namespace limpet
