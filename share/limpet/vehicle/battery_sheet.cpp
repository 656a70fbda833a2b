// SPDX-License-Identifier: MIT
#include "limpet/vehicle/battery_sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace limpet {
namespace {

struct CurvePoint {
  double charge = 0.0;
  double height = 0.0;  ///< of the voltage between empty and full
};
/// A cell of 3.0 V empty and 4.2 V full, at rest: 3.5 V at a tenth, 3.7 V at half its charge.
constexpr std::array<CurvePoint, 5> kCurve{
    {{0.0, 0.0}, {0.1, 0.42}, {0.5, 0.6}, {0.9, 0.88}, {1.0, 1.0}}};

/// The curve's `to` where its `from` is `at`, on the line between the points around it.
double Interpolate(double CurvePoint::*from, double CurvePoint::*to, double at) {
  const double inside = std::clamp(at, 0.0, 1.0);
  std::size_t i = 1;
  while (i + 1 < kCurve.size() && kCurve[i].*from < inside) {
    ++i;
  }
  const CurvePoint &low = kCurve[i - 1], &high = kCurve[i];
  const double share = (inside - low.*from) / (high.*from - low.*from);
  return low.*to + share * (high.*to - low.*to);
}

}  // namespace

double BatterySheet::OpenCircuitVolts(double charge) const {
  return empty_v +
         (full_v - empty_v) * Interpolate(&CurvePoint::charge, &CurvePoint::height, charge);
}

double BatterySheet::ChargeAt(double open_circuit_v) const {
  return Interpolate(&CurvePoint::height, &CurvePoint::charge,
                     (open_circuit_v - empty_v) / (full_v - empty_v));
}

double BatterySheet::ThrusterPower(double thrust) const {
  return full_thrust_w * std::pow(std::abs(thrust), 1.5);
}

}  // namespace limpet
