// SPDX-License-Identifier: MIT
#include "limpet/helm/helm_lead.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/helm/path_chords.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class LeadingHelm : public ::testing::Test {
 protected:
  LeadingHelm() {
    motion_.course = 0.5 * std::numbers::pi;
    motion_.speed = 0.5;
    motion_.depth = 3.0;
  }
  [[nodiscard]] std::vector<std::string> Said() { return std::exchange(said_, {}); }

  std::vector<std::string> said_;
  HelmLead lead_{{.waypoints = "WAY", .depth = "DEPTH", .course = "COURSE", .speed = "SPEED"},
                 [this](const std::string& variable, const Value& value) {
                   said_.push_back(variable + ": " + std::get<std::string>(value));
                 }};
  MotionDecision motion_;
  DubinsPath path_{{.north = 1.0, .east = 2.0, .yaw = 0.0}, {{.curvature = 0.0, .length = 10.0}}};
};

TEST_F(LeadingHelm, TellsDepthThenWayThenThatThereIsOne) {
  lead_.Follow(path_);
  lead_.Steer(true, motion_);
  EXPECT_THAT(Said(), ElementsAre("DEPTH: depth = 3", "WAY: points = 2,1:2,11 # speed = 0.5",
                                  "HELM_LEAD: way"));
}

TEST_F(LeadingHelm, TellsWhatIsNewAlone) {
  lead_.Follow(path_);
  lead_.Steer(true, motion_);
  static_cast<void>(Said());
  lead_.Steer(true, motion_);
  EXPECT_THAT(Said(), IsEmpty());
  motion_.speed = 0.3;
  motion_.depth = 3.2;
  lead_.Steer(true, motion_);
  EXPECT_THAT(Said(), ElementsAre("DEPTH: depth = 3.2", "WAY: speed = 0.3"));
}

TEST_F(LeadingHelm, WithoutAWayTellsCourseAndSpeed) {
  lead_.Steer(false, motion_);
  EXPECT_THAT(Said(), ElementsAre("DEPTH: depth = 3", "COURSE: heading = 90", "SPEED: speed = 0.5",
                                  "HELM_LEAD: course"));
  motion_.speed.reset();
  lead_.Steer(false, motion_);
  EXPECT_THAT(Said(), ElementsAre("HELM_LEAD: hold"));
}

TEST_F(LeadingHelm, BringsTheVehicleUpWhenAllIsToStop) {
  lead_.Follow(path_);
  lead_.Steer(true, motion_);
  static_cast<void>(Said());
  lead_.Stop();
  EXPECT_THAT(Said(), ElementsAre("HELM_LEAD: none", "DEPTH: depth = 0"));
  lead_.Steer(true, motion_);
  EXPECT_THAT(Said(), ElementsAre("DEPTH: depth = 3", "HELM_LEAD: way"))
      << "the other helm has the way still";
}

TEST(WaypointsText, CutsTurnsByATenthOfAMetreAtMost) {
  const double radius = 3.0;
  const DubinsPath turn({.north = 0.0, .east = 0.0, .yaw = 0.0},
                        {{.curvature = 1.0 / radius, .length = std::numbers::pi * radius}});
  const std::vector<MapPoint> points = MapPointsOf(turn, 0.1);
  EXPECT_THAT(WaypointsText(turn), StartsWith("0,0:"));
  ASSERT_GT(points.size(), 4U);
  EXPECT_LT(points.size(), 12U);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double x = 0.5 * (points[i - 1].x + points[i].x) - radius;
    const double y = 0.5 * (points[i - 1].y + points[i].y);
    EXPECT_NEAR(std::hypot(x, y), radius, 0.1);
  }
}

}  // namespace
}  // namespace limpet
