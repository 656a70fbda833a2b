// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/random.hpp"
#include "limpet/topics/sensors.hpp"

namespace limpet {

/// What MeasureGroundContrast finds in SceneRenderer's pictures, without a picture. The figures are
/// those of its pictures (unit_vision compares them); how much contrast the ground has is drawn for
/// each site, since no two are alike.
class ContrastModel {
 public:
  ContrastModel(double visibility_m, Random& site);

  /// Contrast of the ground drawn for a picture taken `range` metres above it.
  [[nodiscard]] GroundContrast Draw(double range, Random& random) const;

  static constexpr double kCloseBy = 0.04;      ///< contrast of the ground without water
  static constexpr double kSiteSpread = 0.4;    ///< of its logarithm, from site to site
  static constexpr double kPatchSpread = 0.15;  ///< of its logarithm, from picture to picture
  static constexpr double kNoise = 0.0024;      ///< what sensor noise shows
  static constexpr double kOtherContrast =
      0.0028;  ///< what lens and specks show where there is no ground

 private:
  double visibility_m_;
  double close_by_;
};

}  // namespace limpet
