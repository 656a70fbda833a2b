// SPDX-License-Identifier: MIT
// Two sessions over the same two objects. GPS is wrong in this one; the former one knew better.
#include <gtest/gtest.h>

#include "tests/unit/navigation/sphere_dive.hpp"

namespace limpet {
namespace {

constexpr double kGpsError = 0.6;  // [m] east, all along

const std::vector<SeabedSphere> kSpheres{{{6.0, 0.4, 6.5}, "yellow"},
                                         {{12.0, -0.5, 6.8}, "orange"}};

/// Both objects, where they are, each known to 0.3 m.
FormerSession KnownBefore() {
  FormerSession former;
  for (const SeabedSphere& sphere : kSpheres) {
    former.objects.push_back({.id = static_cast<int>(former.objects.size()) + 1,
                              .object = {.p_W = sphere.ned,
                                         .cov_W = 0.09 * Eigen::Matrix3d::Identity(),
                                         .color = sphere.color}});
  }
  return former;
}

class SessionTieTest : public ::testing::Test {
 protected:
  SessionTieTest() { dive_.gps_error_ = kGpsError; }
  /// Fixes, a dive over both objects, fixes.
  void Survey() {
    dive_.Go(0.0, 60.0, true);
    dive_.Go(0.5, 40.0, false);
    dive_.Go(0.0, 110.0, false);
    dive_.Go(0.0, 60.0, true);
  }
  SphereDive dive_{kSpheres};
};

TEST_F(SessionTieTest, WithoutAFormerSessionObjectsAreWhereGpsPutsThem) {
  Survey();
  EXPECT_NEAR(dive_.WorstError(), kGpsError, 0.15);
}

TEST_F(SessionTieTest, AFormerSessionHalvesTheError) {
  dive_.navigator().SetFormerSession(KnownBefore());
  Survey();
  EXPECT_LT(dive_.WorstError(), 0.7 * kGpsError);
}

TEST_F(SessionTieTest, OneObjectThatStayedIsNotEnoughToTieTo) {
  FormerSession former = KnownBefore();
  former.objects.pop_back();
  dive_.navigator().SetFormerSession(former);
  Survey();
  EXPECT_NEAR(dive_.WorstError(), kGpsError, 0.15);
}

}  // namespace
}  // namespace limpet
