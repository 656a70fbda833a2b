// SPDX-License-Identifier: MIT
#include "apps/pHelm/helm_drawing.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class HelmDrawingTest : public ::testing::Test {
 protected:
  static ViewDecision Decision(double length, int others) {
    ViewDecision decision;
    decision.chosen = Option{.source = "beam",
                             .path = DubinsPath({.north = 2.0, .east = 5.0, .yaw = 0.0},
                                                {{.curvature = 0.0, .length = length}})};
    decision.bids.options.push_back({.source = "beam", .length = length, .end = {}, .bids = {}});
    for (int i = 0; i < others; ++i) {
      decision.bids.options.push_back(
          {.source = "gap", .length = 9.0, .total = 3.25, .end = {1.0, 2.0 + i}, .bids = {}});
    }
    return decision;
  }
  std::vector<std::string> Take() { return std::exchange(posts_, {}); }

  std::vector<std::string> posts_;
  HelmDrawing drawing_{"alpha", [this](const std::string& variable, const std::string& text) {
                         posts_.push_back(variable + " " + text);
                       }};
};

TEST_F(HelmDrawingTest, AreaAndRegionAreRectanglesInTheViewersAxes) {
  drawing_.DrawArea(
      {.north_min = -15, .north_max = 15, .east_min = -18, .east_max = 18, .margin = 2.0});
  EXPECT_THAT(Take(),
              ElementsAre("VIEW_POLYGON pts={-18,-15:18,-15:18,15:-18,15},label=alpha_area,"
                          "label_color=yellow,edge_color=yellow,vertex_color=invisible,edge_size=1",
                          "VIEW_POLYGON pts={-20,-17:20,-17:20,17:-20,17},label=alpha_region,"
                          "label_color=invisible,edge_color=gray50,vertex_color=invisible,"
                          "edge_size=1"));
}

TEST_F(HelmDrawingTest, APathIsDrawnWithTheEndsOfTheNextBestOptions) {
  drawing_.DrawDecision(Decision(10.0, 1));
  EXPECT_THAT(Take(),
              ElementsAre("VIEW_SEGLIST pts={5,2:5,12},label=alpha_path,msg=beam 10 m,"
                          "label_color=white,edge_color=white,vertex_color=invisible,edge_size=2",
                          "VIEW_POINT x=2,y=1,label=alpha_option_1,msg=gap 3.2,label_color=gray50,"
                          "vertex_color=gray50,vertex_size=3"));
}

TEST_F(HelmDrawingTest, OptionsOfAnEarlierDecisionAreErased) {
  drawing_.DrawDecision(Decision(10.0, 2));
  static_cast<void>(Take());
  drawing_.DrawDecision(Decision(10.0, 1));
  EXPECT_THAT(Take(), ElementsAre("VIEW_POINT x=3,y=1,active=false,label=alpha_option_2,msg=gap "
                                  "3.2,label_color=gray50,vertex_color=gray50,vertex_size=3"));
}

TEST_F(HelmDrawingTest, APathThatNobodyFollowsIsErasedOnce) {
  drawing_.ErasePath();
  EXPECT_THAT(Take(), IsEmpty());
  drawing_.DrawDecision(Decision(10.0, 2));
  static_cast<void>(Take());
  drawing_.ErasePath();
  drawing_.ErasePath();
  EXPECT_THAT(Take(), SizeIs(3));
}

}  // namespace
}  // namespace limpet
