// SPDX-License-Identifier: MIT
// The colours that objects of a survey may have: scenarios paint them in these, detectors name
// their classes by them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limpet {

/// Linear share of light that a surface returns: blue, green, red; 0 to 1.
using Albedo = std::array<float, 3>;

/// Paint of a named colour, or nothing if the table lacks it.
[[nodiscard]] std::optional<Albedo> AlbedoOf(std::string_view color);
/// The names of the table, in its order.
[[nodiscard]] std::vector<std::string> ColorNames();

}  // namespace limpet
