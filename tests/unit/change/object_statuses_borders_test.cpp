// SPDX-License-Identifier: MIT
// What becomes one object, what has moved, and what another entry already tells: just each side.
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/change/object_statuses_fixture.hpp"

namespace limpet {
namespace {

class ObjectStatusesBorders : public ObjectStatusesTest {
 protected:
  /// Landmarks of two passes, that far apart.
  std::size_t CountOfTwo(double apart, std::optional<int> former_a = {},
                         std::optional<int> former_b = {}) {
    const Real a{At(4.0, 0.5), 1, {.id = former_a}}, b{At(4.0 + apart, 0.5), 2, {.id = former_b}};
    Fly(0.0, {a});
    Fly(0.0, {b});
    Landmarks({a, b});
    return static_cast<std::size_t>(statuses_.Representative(1) == statuses_.Representative(2) ? 1
                                                                                               : 2);
  }
  const StatusParams params_{};
};

TEST_F(ObjectStatusesBorders, LandmarksJustInsideTheMergingDistanceAreOne) {
  EXPECT_EQ(CountOfTwo(params_.merge_within.value() - 0.001), 1U);
}

TEST_F(ObjectStatusesBorders, LandmarksJustOutsideTheMergingDistanceAreTwo) {
  EXPECT_EQ(CountOfTwo(params_.merge_within.value() + 0.001), 2U);
}

TEST_F(ObjectStatusesBorders, LandmarksThatAreTwoFormerObjectsAreTwoHoweverNear) {
  statuses_.SetFormer({Former(11, At(4.0, 0.5)), Former(12, At(4.5, 0.5))});
  EXPECT_EQ(CountOfTwo(0.5, 11, 12), 2U);
}

TEST_F(ObjectStatusesBorders, LandmarksThatAreOneFormerObjectMayBeOne) {
  statuses_.SetFormer({Former(11, At(4.0, 0.5))});
  EXPECT_EQ(CountOfTwo(0.5, 11, 11), 1U);
}

TEST_F(ObjectStatusesBorders, HeightDoesNotKeepLandmarksApart) {
  Real a{At(4.0, 0.5), 1}, b{At(4.2, 0.5), 2};
  b.object.p_W.z() -= 2.0;
  Fly(0.0, {a});
  Fly(0.0, {b});
  Landmarks({a, b});
  EXPECT_EQ(statuses_.Representative(2), 1);
}

/// Statuses after an object of the former session was found that far from its place.
class MovedObjects : public ObjectStatusesBorders {
 protected:
  std::vector<Status> AfterAMoveOf(double metres, const std::string& color = "yellow") {
    statuses_.SetFormer({Former(11, At(2.0, 0.0))});
    FormerLookedEverywhere();
    const Real now{At(2.0 + metres, 0.0, color), 1};
    for (int pass = 0; pass < 3; ++pass)
      Fly(0.0, {now});
    Landmarks({now});
    std::vector<Status> decided = Decided();
    std::ranges::sort(decided);
    return decided;
  }
};

TEST_F(MovedObjects, WithinTheReachOfAMoveIsOneThatMoved) {
  EXPECT_EQ(AfterAMoveOf(params_.matching.moved_within.value() - 0.01),
            (std::vector<Status>{Status::kMoved}));
}

TEST_F(MovedObjects, BeyondTheReachOfAMoveIsOneThatWentAndOneThatCame) {
  EXPECT_EQ(AfterAMoveOf(params_.matching.moved_within.value() + 0.01),
            (std::vector<Status>{Status::kRemoved, Status::kNew}));
}

TEST_F(MovedObjects, OfAnotherColourIsAnotherObject) {
  EXPECT_EQ(AfterAMoveOf(2.0, "red"), (std::vector<Status>{Status::kRemoved, Status::kNew}));
}

TEST_F(MovedObjects, KeepsTheFormerObjectsIdInItsStory) {
  AfterAMoveOf(2.0);
  const std::vector<OpiBelief> all = statuses_.Assess();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].former_id, 11);
  EXPECT_EQ(all[0].landmark, 1);
}

}  // namespace
}  // namespace limpet
