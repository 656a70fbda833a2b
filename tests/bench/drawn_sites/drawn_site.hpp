// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace limpet {

/// Writes a mission folder for a site drawn from `seed`: an outline (DrawOutline), keep-out zones,
/// a start inside or up to 25 m outside, one to six objects that stay; altitude, depth, band,
/// slope, current and water of a range that surveys are made for, and either vehicle that ships.
/// The vehicle is told outline, zones, altitude and band; of all else it has its defaults. Returns
/// what the site is in a line.
std::string WriteDrawnSite(std::uint64_t seed, const std::filesystem::path& folder);

}  // namespace limpet
