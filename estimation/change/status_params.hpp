// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/change/look_log.hpp"
#include "estimation/change/status.hpp"
#include "estimation/matching/session_matching.hpp"
#include "limpet/core/params.hpp"
#include "limpet/core/units.hpp"
#include "limpet/survey/look.hpp"

namespace limpet {

/// What an ObjectStatuses is told by its mission.
struct StatusParams {
  DetectionModel detection;
  LookParams looks;
  StatusPriors priors;
  MatchingParams matching;         ///< of these only what is needed where matches are given
  double visibility_spread = 2.0;  ///< factor that is one standard deviation of what was expected
  Meters object_radius{0.5};
  Meters merge_within{1.2};

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    detection.Describe(visit);
    looks.Describe(visit);
    priors.Describe(visit);
    matching.DescribeForGivenMatches(visit);
    visit("visibility_spread", visibility_spread,
          "The water's visibility may well be visibility_m times or by this factor",
          InRange(1.05, 10.0));
    visit.Required("object_radius_m", object_radius, "Radius of the objects looked for",
                   InRange(0.05_m, 5.0_m));
    visit("merge_within_m", merge_within,
          "Landmarks closer than this and never seen together are one object",
          InRange(0.0_m, 10.0_m));
  }
  /// What judges a look of `camera` at an object of the usual size.
  [[nodiscard]] LookModel LookFrom(const CameraModel& camera) const {
    return {.camera = camera, .detection = detection, .object_radius = object_radius.value()};
  }
};

}  // namespace limpet
