// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace limpet {

/// What becomes of a site's objects between discovery and change.
enum class Fates { kStay, kDrawn };

/// Writes a mission folder for a site drawn from `seed`: an outline (DrawOutline), keep-out zones,
/// a start inside or up to 25 m outside, one to six objects; altitude, depth, band, slope, current
/// and water of a range that surveys are made for, and either vehicle that ships. Where fates are
/// drawn, about half of the objects stay, a fifth go, a fifth come, and the others are moved by 1
/// to 2.2 m. The vehicle is told outline, zones, altitude and band; of all else it has its
/// defaults. Returns what the site is in a line.
std::string WriteDrawnSite(std::uint64_t seed, Fates fates, const std::filesystem::path& folder);

}  // namespace limpet
