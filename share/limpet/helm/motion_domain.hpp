// SPDX-License-Identifier: MIT
// The helm's decision variables as a mission writes them: `domain = speed:0:1:21`.
#pragma once

#include <array>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "limpet/core/config.hpp"

namespace limpet {

/// What the helm decides on, in this order wherever they stand in a row.
enum class MotionVariable { kCourse, kSpeed, kDepth };
inline constexpr std::array kMotionVariables{MotionVariable::kCourse, MotionVariable::kSpeed,
                                             MotionVariable::kDepth};
/// The variable's name as missions write it: course, speed, depth.
[[nodiscard]] const char* NameOf(MotionVariable variable);
[[nodiscard]] constexpr std::size_t IndexOf(MotionVariable variable) {
  return static_cast<std::size_t>(variable);
}

/// The values that a decision variable may take: evenly spaced points, both ends included, or one
/// where these are the same. Courses in radians clockwise from north, speeds in m/s, depths in m.
struct MotionAxis {
  double low = 0.0, high = 1.0;
  int points = 2;
  bool is_optional = false;  ///< the helm drives on where nobody bids on it

  [[nodiscard]] double step() const { return points > 1 ? (high - low) / (points - 1) : 0.0; }
  [[nodiscard]] double At(int point) const { return low + point * step(); }
  bool operator==(const MotionAxis&) const = default;
};

/// What the helm decides on; a variable that is absent is left to others. Bids of peaks alone are
/// maximised over the continuum, others over the points.
struct MotionDomain {
  std::optional<MotionAxis> course =
      MotionAxis{.low = 0.0, .high = 359.0 / 180.0 * std::numbers::pi, .points = 360};
  std::optional<MotionAxis> speed = MotionAxis{.low = 0.0, .high = 1.0, .points = 21};
  std::optional<MotionAxis> depth = MotionAxis{.low = 0.0, .high = 100.0, .points = 1001};

  [[nodiscard]] const std::optional<MotionAxis>& axis(MotionVariable variable) const;
  /// How many points a variable has; 1 if it is absent.
  [[nodiscard]] int points(MotionVariable variable) const;
  bool operator==(const MotionDomain&) const = default;
};

/// Reads `name:low:high:points[:optional]` lines into `domain`, whose variables are then those of
/// the lines; every problem. Commas may stand for the colons, `delta=STEP` for the points, and any
/// word that is not `optional` behind them for nothing, as in MOOS-IvP; a speed or a depth may be
/// one value alone, as `depth:0:0:1`. Course and speed must each be there once; without depth none
/// is decided.
[[nodiscard]] std::vector<ConfigProblem> ReadMotionDomain(std::span<const ConfigEntry> lines,
                                                          const SourceLine& block,
                                                          MotionDomain& domain);

/// `speed,0,1,21:course,0,359,360`, as IVPHELM_DOMAIN has it: the last line comes first.
[[nodiscard]] std::string MotionDomainText(std::span<const std::string> lines);

}  // namespace limpet
