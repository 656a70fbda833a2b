// SPDX-License-Identifier: MIT
#include "limpet/waypoints/point_list.hpp"

#include <string>

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(PointList, OfAMissionMaySayHowItIsDrawn) {
  for (const char* text :
       {"pts={0,0:9,0:9,9},label=pier", "label=pier,msg=keep off, pts={0,0:9,0:9,9}",
        "\"pts={0,0:9,0:9,9},edge_color=red,vertex_size=2,fill_transparency=0.3,active=true\"",
        "pts={0,0:9,0:9,9}"}) {
    const auto points = ParsePoints(text);
    ASSERT_TRUE(points) << text;
    EXPECT_EQ(points->size(), 3U);
    EXPECT_EQ(BesidePoints(text), "") << text;
  }
}

TEST(PointList, TellsWhatNobodyWouldReadBesideThePoints) {
  EXPECT_EQ(BesidePoints("pts={0,0:9,0:9,9} {1,1:2,1:2,2}"), "{1,1:2,1:2,2}");
  EXPECT_EQ(BesidePoints("pts={0,0:9,0:9,9} garbage here"), "garbage here");
  EXPECT_EQ(BesidePoints("1,1:2,1:2,2, pts={0,0:9,0:9,9}"), "1,1:2,1:2,2,");
  EXPECT_EQ(BesidePoints("pts={0,0:9,0:9,9},keep_out=0"), ",keep_out=0");
  EXPECT_EQ(BesidePoints("0,0:9,0:9,9"), "") << "there are no braces to be beside";
}

TEST(PointList, IsNoneWithASecondPolygonThatWouldBeLost) {
  for (const char* between : {" ", ", ", "; ", ":", ""}) {
    EXPECT_FALSE(ParsePoints(std::string("pts={0,0:9,0:9,9}") + between + "pts={1,1:2,1:2,2}"))
        << between;
  }
}

TEST(PointList, TakesWhatStockMissionsSayBesideIt) {
  EXPECT_TRUE(ParsePoints("pts={0,0:9,0:9,9},spec=own,whatever=1")) << "behaviors pass over it";
  EXPECT_TRUE(ParsePoints("radial:: x=0, y=0, radius=10, pts=6, snap=1"));
}

}  // namespace
}  // namespace limpet
