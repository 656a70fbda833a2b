// SPDX-License-Identifier: MIT
// Corners as MOOS-IvP's own libraries lay them (moos-ivp of 2026), to a hundredth of a metre.
#include "limpet/waypoints/figure_points.hpp"

#include <string>

#include <gtest/gtest.h>

#include "limpet/waypoints/point_list.hpp"

namespace limpet {
namespace {

struct Laid {
  const char* name;
  const char* text;
  const char* corners;
};

class StockFigure : public ::testing::TestWithParam<Laid> {};

TEST_P(StockFigure, HasTheCornersOfMoosIvp) {
  const auto points = ParsePoints(GetParam().text);
  ASSERT_TRUE(points) << GetParam().text;
  const auto expected = ParsePoints(GetParam().corners);
  ASSERT_TRUE(expected);
  ASSERT_EQ(points->size(), expected->size()) << PointsText(*points);
  for (std::size_t i = 0; i < points->size(); ++i) {
    EXPECT_NEAR((*points)[i].x, (*expected)[i].x, 0.006) << i;
    EXPECT_NEAR((*points)[i].y, (*expected)[i].y, 0.006) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Missions, StockFigure,
    ::testing::Values(
        Laid{"LanesBeginAtTheCornerNearestToTheStart",
             "format=lawnmower, x=0, y=40, width=30, height=60, swath=10, rows=north-south, "
             "startx=50, starty=90",
             "15,70:15,10:5,10:5,70:-5,70:-5,10:-15,10:-15,70"},
        Laid{"LanesGoEastAndWestUnlessSaid",
             "format=lawnmower, label=survey, x=80, y=-80, width=70, height=30, lane_width=8",
             "45,-65:115,-65:115,-73:45,-73:45,-81:115,-81:115,-89:45,-89:45,-97:115,-97"},
        Laid{"TurnedLanes", "lawnmower:x=0, y=0, width=70, height=21, lane_width=7, degs=20",
             "36.48,-2.10:-29.30,21.84:-31.69,15.26:34.09,-8.68:31.69,-15.26:-34.09,8.68:-36.48,"
             "2.10:29.30,-21.84"},
        Laid{"Bowtie",
             "format=bowtie, label=dudley_bowtie, x=80, y=-80, wid1=10, wid2=25, wid3=30, "
             "height=20",
             "70,-90:55,-90:50,-80:55,-70:70,-70:90,-90:105,-90:110,-80:105,-70:90,-70"},
        Laid{"BowtieFromTheSouthWest",
             "format=bowtie, x=80, y=-80, wid1=10, wid2=25, wid3=30, height=20, startx=0, "
             "starty=-200",
             "90,-70:105,-70:110,-80:105,-90:90,-90:70,-70:55,-70:50,-80:55,-90:70,-90"},
        Laid{"Zigzag", "zigzag:0,0,45,30,20,50,1", "0,0:-32,39:46,-25:-18,53"},
        Laid{"Radial", "radial:: x=10,y=20,radius=20,pts=8,snap=1,label=a",
             "18,38:28,28:28,12:18,2:2,2:-8,12:-8,28:2,38"},
        Laid{"RadialInShort", "radial:10,20,20,6,0.1,lab",
             "20,37.3:30,20:20,2.7:0,2.7:-10,20:0,37.3"},
        Laid{"EllipseTurnedFromEastToNorth", "ellipse:x=10,y=20,rads=0.5,pts=4,major=100,minor=70",
             "-33.88,-3.97:26.78,-10.72:53.88,43.97:-6.78,50.72"},
        Laid{"Wedge", "format=wedge,x=0,y=0,lang=20,rang=70,range=50,pts=5",
             "0,0:17.10,46.98:25,43.30:32.14,38.30:38.30,32.14:43.30,25:46.98,17.10"},
        Laid{"Pylon", "pylon:x1=0,y1=0,x2=30,y2=40,axis_pad=5,perp_pad=10",
             "-11,2:5,-10:41,38:25,50"},
        Laid{"PointsWithALabel", "label,transit:190,25:155,-20", "190,25:155,-20"},
        Laid{"PointsWithNamedAxes", "pts={x=10,y=20:x=30,y=40,z=2}, label=a", "10,20:30,40"}),
    [](const ::testing::TestParamInfo<Laid>& laid) { return std::string(laid.param.name); });

TEST(FigurePoints, AnOvalIsTwoHalfCirclesAndTheStraightsBetweenThem) {
  const auto points = FigurePoints("oval: x=10,y=20, rad=15, len=140, ang=64");
  ASSERT_TRUE(points);
  ASSERT_EQ(points->size(), 26u);
  EXPECT_NEAR(points->front().x, 52.86, 0.006);
  EXPECT_NEAR(points->front().y, 57.59, 0.006);
  EXPECT_NEAR((*points)[13].x, -32.86, 0.006);
  EXPECT_NEAR((*points)[13].y, -17.59, 0.006);
}

TEST(FigurePoints, WhatIsNoFigureOrTooLargeIsNone) {
  for (const char* text :
       {"format=spiral,x=0,y=0", "radial:10,20,20", "radial:a,b,c,d", "format=radial,x=1,y=1",
        "format=lawnmower,x=0,y=0,width=1e9,height=10,lane_width=1e-3", "zigzag:0,0,0,1e9,1e-3,1",
        "format=radial,x=1,y=1,radius=9,pts=1e7", "format=oval,x=0,y=0,rad=10,len=5,ang=0",
        "format=radial,x=1.7e308,y=0,radius=1.7e308,pts=4", "", "label,alone", "1,2:transit"}) {
    EXPECT_FALSE(ParsePoints(text)) << text;
  }
}

}  // namespace
}  // namespace limpet
