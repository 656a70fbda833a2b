// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include "limpet/helm/situation.hpp"
#include "limpet/planning/ground.hpp"

namespace limpet {

/// A vehicle at the origin that heads north, over ground of which nothing has been seen.
class ViewBehaviorTest : public ::testing::Test {
 protected:
  ViewBehaviorTest() {
    now_.ground = &ground_;
    now_.region = &region_;
  }
  Option& Straight(double length, double yaw = 0.0) {
    option_ = {.source = "beam", .path = DubinsPath({0.0, 0.0, yaw}, {{0.0, length}})};
    return option_;
  }
  [[nodiscard]] Prospect Seen(const Option& option, double area = 0.0, double border = 0.0) const {
    return {option, {.new_area = area, .frontier_growth = border}};
  }
  static double Reason(const Bid& bid, const std::string& name) {
    for (const auto& reason : bid.why) {
      if (reason.name == name) return reason.value;
    }
    ADD_FAILURE() << "no reason `" << name << "`";
    return 0.0;
  }
  static WatchedObject ObjectAt(double north, double east, const StatusPosterior& posterior) {
    WatchedObject object;
    object.belief.id = 4;
    object.belief.object.p_W = {north, east, 6.0};
    object.belief.posterior = posterior;
    object.window = LookWindow{.half_along = 1.0, .half_across = 1.0};
    return object;
  }

  SurveyArea area_{-40.0, 40.0, -40.0, 40.0, 2.0, 2.0};
  SurveyGrid grid_{area_};
  Ground ground_{grid_, Footprint({.altitude = 4.0, .object_height_max = 2.0}, CameraModel{})};
  Region region_{area_};
  Situation now_;
  Option option_;
};

}  // namespace limpet
