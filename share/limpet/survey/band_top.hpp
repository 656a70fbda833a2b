// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace limpet {

/// How high objects may reach, and from where they are looked at. Metres above the seabed.
struct BandView {
  double object_height_max = 0.0;  ///< of their centres; 0: the bottom alone is surveyed
  double object_radius = 0.0;      ///< 0: not known
  double altitude = 0.0;           ///< of the camera
};

/// Why objects that high cannot be surveyed from there; nothing if they can. `altitude_named` says
/// where the altitude comes from.
[[nodiscard]] std::optional<std::string> ProblemOf(const BandView& view,
                                                   std::string_view altitude_named);

}  // namespace limpet
