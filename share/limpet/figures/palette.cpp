// SPDX-License-Identifier: MIT
#include "limpet/figures/palette.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace limpet::palette {
namespace {

Rgb Between(std::span<const Rgb> stops, double share) {
  const double at = std::clamp(share, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const double f = at - static_cast<double>(i);
  Rgb out{};
  for (std::size_t k = 0; k < 3; ++k) {
    out[k] = static_cast<std::uint8_t>(std::lround((1.0 - f) * stops[i][k] + f * stops[i + 1][k]));
  }
  return out;
}

}  // namespace

Rgb Viridis(double share) {
  static constexpr Rgb kStops[] = {{68, 1, 84},    {72, 40, 120},  {62, 74, 137},  {49, 104, 142},
                                   {38, 130, 142}, {31, 158, 137}, {53, 183, 121}, {110, 206, 88},
                                   {181, 222, 43}, {253, 231, 37}};
  return Between(kStops, share);
}

Rgb Coverage(double share) {
  static constexpr Rgb kStops[] = {
      {228, 241, 241}, {200, 228, 229}, {168, 212, 214}, {136, 196, 200}};
  return Between(kStops, share);
}

}  // namespace limpet::palette
