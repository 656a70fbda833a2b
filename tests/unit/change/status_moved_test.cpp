// SPDX-License-Identifier: MIT
// Which of those that went and came are one object that has moved, and how sure that is.
#include <algorithm>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/change/object_statuses_fixture.hpp"

namespace limpet {
namespace {

class StatusMovedTest : public ObjectStatusesTest {
 protected:
  /// Former objects that are gone, and newcomers, as landmarks from 1 on.
  std::vector<OpiBelief> After(const std::vector<FormerObject>& former,
                               const std::vector<ObjectEstimate>& came) {
    FormerLookedEverywhere();
    statuses_.SetFormer(former);
    std::vector<Real> now;
    for (const ObjectEstimate& object : came)
      now.push_back({object, static_cast<int>(now.size()) + 1});
    for (int pass = 0; pass < 3; ++pass)
      Fly(0.0, now);
    Landmarks(now);
    return statuses_.Assess();
  }
  static std::optional<OpiBelief> OfLandmark(const std::vector<OpiBelief>& all, int landmark) {
    const auto found = std::ranges::find(all, std::optional(landmark), &OpiBelief::landmark);
    return found == all.end() ? std::nullopt : std::optional(*found);
  }
};

TEST_F(StatusMovedTest, TheNearestNewcomerIsTheOneThatMoved) {
  // The farther one has the lower id, so it comes first.
  const auto all = After({Former(11, At(3.0, 0.0))}, {At(5.2, 0.0), At(3.0, 1.0)});
  ASSERT_TRUE(OfLandmark(all, 1) && OfLandmark(all, 2));
  EXPECT_EQ(OfLandmark(all, 1)->decided, Status::kNew);
  EXPECT_EQ(OfLandmark(all, 2)->decided, Status::kMoved);
  EXPECT_EQ(OfLandmark(all, 2)->former_id, 11);
}

TEST_F(StatusMovedTest, TwoThatMovedAreEachPairedWithItsOwn) {
  const auto all =
      After({Former(11, At(2.0, 0.0)), Former(12, At(4.2, 0.0))}, {At(4.2, 1.0), At(2.0, 1.0)});
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(OfLandmark(all, 1)->former_id, 12);
  EXPECT_EQ(OfLandmark(all, 2)->former_id, 11);
}

TEST_F(StatusMovedTest, SaysHowSureItIsThatItIsOneObject) {
  const auto near = After({Former(11, At(3.0, 0.0))}, {At(3.0, 1.2)});
  ASSERT_EQ(near.size(), 1U);
  ASSERT_TRUE(near[0].moved_probability);
  EXPECT_GT(*near[0].moved_probability, 0.85);
  EXPECT_LT(*near[0].moved_probability, near[0].posterior.appeared)
      << "that it was not there before is part of it";
}

TEST_F(StatusMovedTest, WhatHasNotMovedHasNoSuchProbability) {
  for (const OpiBelief& object : After({Former(11, At(0.0, 0.0))}, {At(7.0, 0.5)}))
    EXPECT_FALSE(object.moved_probability);
}

}  // namespace
}  // namespace limpet
