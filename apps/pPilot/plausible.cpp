// SPDX-License-Identifier: MIT
#include "apps/pPilot/plausible.hpp"

#include <algorithm>
#include <array>

namespace limpet {
namespace {

constexpr PlausibleRange kPlace{-1e7, 1e7};        // [m] from the datum
constexpr PlausibleRange kAngle{-6.2832, 6.2832};  // [rad]
constexpr PlausibleRange kVelocity{-50.0, 50.0};   // [m/s]
constexpr PlausibleRange kRate{-20.0, 20.0};       // [rad/s]

template <std::size_t N>
bool AllIn(const PlausibleRange& range, const std::array<double, N>& values) {
  return std::ranges::all_of(values, [&range](double value) { return range.Has(value); });
}

}  // namespace

bool IsPlausible(const NavState& nav) {
  return AllIn(kPlace, std::array{nav.north, nav.east}) && kPlausibleDepth.Has(nav.down) &&
         AllIn(kAngle, std::array{nav.roll, nav.pitch, nav.yaw}) &&
         AllIn(kVelocity, std::array{nav.u, nav.v, nav.w}) && kRate.Has(nav.yaw_rate);
}

}  // namespace limpet
