// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "limpet/core/units.hpp"
#include "limpet/topics/navigation.hpp"

namespace limpet {

/// Whether depth and altitude agree: together they are the seabed's depth, which does not change
/// faster than ground slopes. A sensor of the two that sticks shows as soon as the vehicle dives or
/// climbs.
class SeabedWatch {
 public:
  /// `nav` at `now`, which does not go back.
  void Hear(const NavState& nav, Seconds now);
  /// Greatest change of the seabed's depth within the last 10 s beyond what a steep slope explains
  /// [m], as last heard; absent without altitudes.
  [[nodiscard]] std::optional<double> step() const { return step_; }

 private:
  struct Sounding {
    Seconds time;
    double north = 0.0, east = 0.0, seabed = 0.0;  ///< [m]
  };
  static constexpr std::size_t kKept = 20;

  std::array<Sounding, kKept> kept_{};
  std::size_t count_ = 0;  ///< ever kept
  std::optional<double> step_;
};

}  // namespace limpet
