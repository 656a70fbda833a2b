// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/params.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// How well a detector sees in this water: what pMap's block says, MAP_LOOK carries and a
/// detector's file brings. What follows from it for a frame: survey/detection_chance.hpp.
struct DetectionModel {
  double best = 0.97;             ///< chance per frame close by and wholly inside the image
  Meters visibility{8.0};         ///< range at which contrast is gone
  double half_range = 1.1;        ///< over the visibility: there half of the best chance is left
  double fall_off = 0.06;         ///< over the visibility: within so much it falls
  double least_size_px = 17.0;    ///< diameter of an object's image of which half are found
  double share_none = 0.2;        ///< share of the object inside the image below which it is missed
  double share_full = 0.6;        ///< and above which the image's border does not matter
  double false_per_image = 0.03;  ///< boxes per image that show nothing

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit("detection_best", best, "Chance per frame to detect an object close by",
          InRange(0.05, 0.999));
    visit("visibility_m", visibility, "Range at which an object's contrast is gone",
          InRange(0.5_m, 100.0_m));
    visit("detection_half_range", half_range,
          "Range at which half of that is left, over the visibility", InRange(0.2, 3.0));
    visit("detection_fall_off", fall_off, "Width of its fall there, over the visibility",
          InRange(0.005, 0.5));
    visit("detection_least_size_px", least_size_px,
          "Diameter of an object's image of which half are found", InRange(1.0, 200.0));
    visit("detection_share_none", share_none,
          "Share of an object inside the image below which it is missed", InRange(0.0, 0.9));
    visit("detection_share_full", share_full,
          "Share of an object inside the image above which the border does not matter",
          InRange(0.05, 1.0));
    visit("false_detections_per_image", false_per_image, "Boxes per image that show nothing",
          InRange(1e-4, 1.0));
  }
};

}  // namespace limpet
