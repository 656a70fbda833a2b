// SPDX-License-Identifier: MIT
#include "apps/pMap/map_drawing.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class MapDrawingTest : public ::testing::Test {
 protected:
  static OpiBelief Belief(int id, Status status, double north = 4.0) {
    OpiBelief belief;
    belief.id = id;
    belief.object.p_W = {north, 1.0, 5.5};
    belief.object.cov_W = Eigen::Vector3d(0.04, 0.09, 0.0).asDiagonal();
    belief.object.color = "yellow";
    belief.decided = status;
    return belief;
  }
  std::vector<std::string> Draw(const std::vector<OpiBelief>& beliefs) {
    posts_.clear();
    drawing_.Draw({beliefs});
    return posts_;
  }
  std::vector<std::string> posts_;
  MapDrawing drawing_{"alpha", [this](const std::string& variable, const std::string& text) {
                        posts_.push_back(variable + " " + text);
                      }};
};

TEST_F(MapDrawingTest, AnObjectIsAMarkerOfItsStatusAndACircleOfOneSigma) {
  EXPECT_THAT(Draw({Belief(3, Status::kConfirmed)}),
              ElementsAre("VIEW_MARKER x=1,y=4,width=0.5,primary_color=green,type=circle,"
                          "label=alpha_opi_3,msg=yellow confirmed,label_color=green",
                          "VIEW_CIRCLE x=1,y=4,radius=0.3,label=alpha_opi_3,label_color=invisible,"
                          "edge_color=green,edge_size=1"));
}

TEST_F(MapDrawingTest, CentimetresAreNotWorthAPost) {
  static_cast<void>(Draw({Belief(3, Status::kNew)}));
  EXPECT_THAT(Draw({Belief(3, Status::kNew, 4.05)}), IsEmpty());
  EXPECT_THAT(Draw({Belief(3, Status::kNew, 4.15)}), SizeIs(2));
}

TEST_F(MapDrawingTest, ARemovedObjectLosesItsCircleAndKeepsItsMarker) {
  static_cast<void>(Draw({Belief(3, Status::kUncertain)}));
  EXPECT_THAT(Draw({Belief(3, Status::kRemoved)}),
              ElementsAre("VIEW_MARKER x=1,y=4,width=0.5,primary_color=orangered,type=square,"
                          "label=alpha_opi_3,msg=yellow removed,label_color=orangered",
                          "VIEW_CIRCLE x=1,y=4,radius=0.3,active=false,label=alpha_opi_3,"
                          "label_color=invisible,edge_color=yellow,edge_size=1"));
}

TEST_F(MapDrawingTest, WhatIsNoObjectAnyMoreIsErased) {
  static_cast<void>(Draw({Belief(3, Status::kUncertain), Belief(4, Status::kNew)}));
  EXPECT_THAT(Draw({Belief(4, Status::kNew)}), SizeIs(2));
}

}  // namespace
}  // namespace limpet
