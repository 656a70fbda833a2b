// SPDX-License-Identifier: MIT
#include "estimation/mapping/depth_map.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

constexpr double kCell = 0.2;

std::vector<Eigen::Vector3d> RandomEnds(int count, double sigma) {
  Random random(21);
  std::vector<Eigen::Vector3d> ends;
  for (int i = 0; i < count; ++i) {
    const double north = random.Uniform(-4.0, 4.0);
    ends.emplace_back(north, random.Uniform(-4.0, 4.0), 7.5 + random.Normal(sigma));
  }
  return ends;
}

DepthMap DepthsAt(const std::vector<Eigen::Vector3d>& ends) {
  DepthMap map(kCell);
  for (const Eigen::Vector3d& end : ends) {
    map.Add(end);
  }
  return map;
}

TEST(DepthMap, AColumnHasTheMeanOfItsBeamsFinerThanAVoxel) {
  const DepthMap map = DepthsAt({{0.05, 0.05, 7.412}, {0.15, 0.15, 7.436}, {-0.05, 0.05, 7.3}});
  const std::vector<DepthColumn> columns = map.Columns();
  ASSERT_EQ(columns.size(), 2U);
  EXPECT_NEAR(columns[0].north, -0.1, 1e-12);
  EXPECT_NEAR(columns[1].north, 0.1, 1e-12);
  EXPECT_NEAR(columns[1].east, 0.1, 1e-12);
  EXPECT_NEAR(columns[1].down, 7.424, 1e-9);
  EXPECT_EQ(columns[1].beams, 2U);
}

TEST(DepthMap, WhatIsTakenBackLeavesNothing) {
  const std::vector<Eigen::Vector3d> ends = RandomEnds(1000, 0.1);
  DepthMap map = DepthsAt(ends);
  const std::string before = map.Serialize();
  map.Add({0.0, 0.0, 7.0});
  map.TakeBack({0.0, 0.0, 7.0});
  EXPECT_EQ(map.Serialize(), before);
  for (const Eigen::Vector3d& end : ends) {
    map.TakeBack(end);
  }
  EXPECT_TRUE(map.Columns().empty());
}

TEST(DepthMap, SigmasAreWhatBeamsReallyScatterBy) {
  constexpr double kScatter = 0.06;
  double squares = 0.0;
  const std::vector<DepthColumn> columns = DepthsAt(RandomEnds(8000, kScatter)).Columns();
  for (const DepthColumn& column : columns) {
    const double own =
        std::sqrt(column.sigma * column.sigma - DepthMap::kShared * DepthMap::kShared);
    squares += std::pow((column.down - 7.5) / own, 2);
  }
  EXPECT_NEAR(squares / static_cast<double>(columns.size()), 1.0, 0.1);
}

TEST(DepthMap, MoreBeamsTellADepthBetterDownToWhatTheyShare) {
  Random random(2);
  DepthMap map(kCell);
  for (int i = 0; i < 1000; ++i) {
    map.Add({0.1, 0.1, 7.5 + random.Normal(0.05)});
    if (i % 100 == 0) map.Add({1.1, 0.1, 7.5 + random.Normal(0.05)});
  }
  const std::vector<DepthColumn> columns = map.Columns();
  ASSERT_EQ(columns.size(), 2U);
  EXPECT_NEAR(columns[0].sigma, DepthMap::kShared, 1e-3);
  EXPECT_NEAR(columns[1].sigma, std::hypot(0.05 / std::sqrt(10.0), DepthMap::kShared), 3e-3);
}

TEST(DepthMap, ASingleBeamIsAsUncertainAsBeamsOfOtherColumnsScatter) {
  std::vector<Eigen::Vector3d> ends = RandomEnds(4000, 0.08);
  ends.emplace_back(20.0, 20.0, 7.5);
  EXPECT_NEAR(DepthsAt(ends).Columns().back().sigma, std::hypot(0.08, DepthMap::kShared), 0.005);
}

TEST(DepthMap, LeavesOutWhatIsNoPlace) {
  DepthMap map(kCell);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e30}) {
    map.Add({bad, 0.0, 7.0});
    map.Add({0.0, 0.0, bad});
  }
  EXPECT_TRUE(map.Columns().empty());
}

TEST(DepthMap, ComesBackFromItsText) {
  DepthMap map = DepthsAt(RandomEnds(500, 0.1));
  map.SetZeroSigma(0.07);
  const std::string text = map.Serialize();
  const Expected<DepthMap> loaded = DepthMap::Parse(text);
  ASSERT_TRUE(loaded) << loaded.error().text;
  EXPECT_EQ(loaded->Serialize(), text);
  EXPECT_EQ(loaded->zero_sigma(), 0.07);
  EXPECT_EQ(loaded->Columns().size(), map.Columns().size());
}

TEST(DepthMap, NamesTheLineThatItDoesNotUnderstand) {
  const std::string head = "cell_m=0.2,zero_sigma_m=0\nnorth,east,beams,down_mm,square_mm2\n";
  EXPECT_TRUE(DepthMap::Parse(head));
  EXPECT_TRUE(DepthMap::Parse(head + "0,0,1,7500,56250000\n1,-5,1,7500,56250000\n"));
  for (const char* bad : {"0,0,1,7500\n", "0,0,0,0,0\n", "0,0,1,7500,5,6\n", "0,0,1,x,5\n", "\n",
                          "99999999999,0,1,7500,56250000\n", "0,0,1,99000000000,1\n"}) {
    const Expected<DepthMap> read = DepthMap::Parse(head + "-9,0,1,7500,56250000\n" + bad);
    ASSERT_FALSE(read) << bad;
    EXPECT_EQ(read.error().text, "line 4: no column");
  }
  EXPECT_EQ(DepthMap::Parse(head + "0,0,1,7,49\n0,0,1,7,49\n").error().text,
            "line 4: out of order");
  for (const char* bad :
       {"", "cell_m=0\n", "cell_m=0,zero_sigma_m=0\n", "cell_m=0.2,zero_sigma_m=0\n",
        "cell_m=0.2,zero_sigma_m=-1\nnorth,east,beams,down_mm,square_mm2\n"}) {
    EXPECT_FALSE(DepthMap::Parse(bad)) << bad;
  }
}

}  // namespace
}  // namespace limpet
