// SPDX-License-Identifier: MIT
// Colours of figures and page. Statuses are from Okabe and Ito's colour-blind safe set, and never
// told apart by colour alone. The page turns ink, muted, grid and paper over in dark mode; what
// lies on a map keeps its colours, because the map keeps its own light ground.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace limpet::palette {

inline constexpr std::string_view kFont =
    "system-ui, 'Segoe UI', Roboto, 'Helvetica Neue', 'Noto Sans', Arial, sans-serif";

inline constexpr std::string_view kInk = "#1b2a34";
inline constexpr std::string_view kMuted = "#5b6d79";
inline constexpr std::string_view kGrid = "#dde4e8";
inline constexpr std::string_view kPaper = "#ffffff";

inline constexpr std::string_view kUnseen = "#eceff1";  ///< ground of a map, never seen
inline constexpr std::string_view kMapInk = "#14212a";  ///< lines and text on a map
inline constexpr std::string_view kMapMuted = "#4c5b66";
inline constexpr std::string_view kHalo = "#fbfcfd";

inline constexpr std::string_view kBlue = "#0072b2";
inline constexpr std::string_view kSky = "#56b4e9";
inline constexpr std::string_view kGreen = "#009e73";
inline constexpr std::string_view kVermillion = "#d55e00";
inline constexpr std::string_view kOrange = "#e69f00";
inline constexpr std::string_view kPurple = "#cc79a7";

using Rgb = std::array<std::uint8_t, 3>;

/// Viridis, from dark blue at 0 to yellow at 1.
[[nodiscard]] Rgb Viridis(double share);
/// From pale to deep teal: light enough that dark lines stay legible on it.
[[nodiscard]] Rgb Coverage(double share);

}  // namespace limpet::palette
