// SPDX-License-Identifier: MIT
// A former session that only a fix makes recognisable: the dive drifted further than either session
// holds possible.
#include "estimation/navigation/former_matching.hpp"

#include <optional>
#include <set>

#include <gtest/gtest.h>

#include "tests/unit/navigation/sphere_dive.hpp"

namespace limpet {
namespace {

const std::vector<SeabedSphere> kFarSpheres{
    {{48.0, 0.4, 6.5}, "yellow"}, {{52.0, -0.5, 6.8}, "orange"}, {{56.0, 0.3, 6.6}, "yellow"}};

/// Where the spheres are, each known to 0.2 m.
FormerSession FarSpheresOf(const std::vector<SeabedSphere>& spheres) {
  FormerSession former;
  for (const SeabedSphere& sphere : spheres) {
    former.objects.push_back({.id = 41 + static_cast<int>(former.objects.size()),
                              .object = {.p_W = sphere.ned,
                                         .cov_W = 0.04 * Eigen::Matrix3d::Identity(),
                                         .color = sphere.color}});
  }
  return former;
}

class FormerMatchingTest : public ::testing::Test {
 protected:
  /// Fixes, then a long way under water to the spheres and over them.
  void Dive() {
    dive_.Go(0.0, 60.0, true);
    dive_.Go(0.5, 125.0, false);
    dive_.Go(0.0, 20.0, false);
  }
  void Surface() { dive_.Go(0.0, 60.0, true); }
  /// Landmarks that are decided to be a former object; the right one each.
  [[nodiscard]] std::size_t CountMatched() {
    std::set<int> matched;
    for (const Landmark& landmark : dive_.navigator().Landmarks()) {
      if (!landmark.former.is_decided()) continue;
      EXPECT_TRUE(matched.insert(*landmark.former.id).second) << "one former object of two";
      const auto i = static_cast<std::size_t>(*landmark.former.id - 41);
      EXPECT_EQ(landmark.object.color, kFarSpheres[i].color);
    }
    return matched.size();
  }
  SphereDive dive_{kFarSpheres};
};

TEST_F(FormerMatchingTest, WithoutDriftTheSessionIsRecognisedUnderWater) {
  dive_.navigator().SetFormerSession(FarSpheresOf(kFarSpheres));
  Dive();
  EXPECT_EQ(CountMatched(), kFarSpheres.size());
}

TEST_F(FormerMatchingTest, AFewMetresFartherOffThanSessionsSayObjectsThatAgreeAreKnown) {
  dive_.velocity_error_ = 0.08;
  dive_.navigator().SetFormerSession(FarSpheresOf(kFarSpheres));
  Dive();
  EXPECT_EQ(CountMatched(), kFarSpheres.size());
}

TEST_F(FormerMatchingTest, AfterADriftThatNobodyHoldsPossibleTheFixShowsWhichObjectsTheyAre) {
  dive_.velocity_error_ = 0.16;
  dive_.navigator().SetFormerSession(FarSpheresOf(kFarSpheres));
  Dive();
  EXPECT_EQ(CountMatched(), 0U) << "metres off: these might be anything";
  const double drifted = dive_.WorstError();
  EXPECT_GT(drifted, 3.0);
  Surface();
  EXPECT_EQ(CountMatched(), kFarSpheres.size());
  EXPECT_LT(dive_.WorstError(), 0.5 * drifted);
}

TEST_F(FormerMatchingTest, TheFixDoesNotMakeObjectsOfAnotherPlaceKnown) {
  dive_.velocity_error_ = 0.08;
  FormerSession elsewhere = FarSpheresOf(kFarSpheres);
  for (FormerObject& former : elsewhere.objects)
    former.object.p_W += Eigen::Vector3d(9.0, 7.0, 0.0);
  dive_.navigator().SetFormerSession(elsewhere);
  Dive();
  Surface();
  EXPECT_EQ(CountMatched(), 0U);
}

}  // namespace
}  // namespace limpet
