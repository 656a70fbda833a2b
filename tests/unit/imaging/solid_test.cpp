// SPDX-License-Identifier: MIT
#include "limpet/imaging/solid.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

Solid SolidOf(SolidKind kind) {
  return {.kind = kind,
          .radius = 0.4,
          .height = kind == SolidKind::kTyre ? 0.2 : 0.9,
          .top_share = 0.5};
}

class EverySolid : public ::testing::TestWithParam<SolidKind> {};

TEST_P(EverySolid, ReachesAsFarAsItsPointsDo) {
  const Solid solid = SolidOf(GetParam());
  Random random(5);
  for (int direction = 0; direction < 20; ++direction) {
    const Eigen::Vector3d n =
        Eigen::Vector3d(random.Normal(1.0), random.Normal(1.0), random.Normal(1.0)).normalized();
    double farthest = 0.0;
    for (int i = 0; i < 200000; ++i) {
      const Eigen::Vector3d p(random.Uniform(-0.7, 0.7), random.Uniform(-0.7, 0.7),
                              random.Uniform(-0.7, 0.7));
      if (p.dot(n) > farthest && solid.DistanceTo(p) <= 0.0) farthest = p.dot(n);
    }
    EXPECT_LE(farthest, solid.ReachAlong(n) + 1e-9);
    EXPECT_GT(farthest, solid.ReachAlong(n) - 0.05);
  }
}

TEST_P(EverySolid, IsHeldByItsBoundingSphereAndSaysNoDistanceThatIsTooLong) {
  const Solid solid = SolidOf(GetParam());
  Random random(6);
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d p(random.Normal(0.6), random.Normal(0.6), random.Normal(0.6));
    const double distance = solid.DistanceTo(p);
    if (distance <= 0.0) {
      EXPECT_LE(p.norm(), solid.BoundingRadius() + 1e-9);
      continue;
    }
    // A step of that length in any direction stays outside.
    const Eigen::Vector3d step =
        Eigen::Vector3d(random.Normal(1.0), random.Normal(1.0), random.Normal(1.0)).normalized();
    EXPECT_GE(solid.DistanceTo(p + 0.999 * distance * step), 0.0);
  }
}

TEST_P(EverySolid, HasANormalThatIsTheSlopeOfItsDistance) {
  const Solid solid = SolidOf(GetParam());
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d p(random.Normal(0.5), random.Normal(0.5), random.Normal(0.5));
    const Eigen::Vector3d normal = solid.NormalAt(p);
    EXPECT_NEAR(normal.norm(), 1.0, 1e-9);
    constexpr double kStep = 1e-7;
    EXPECT_NEAR((solid.DistanceTo(p + kStep * normal) - solid.DistanceTo(p)) / kStep, 1.0, 1e-4);
  }
}

INSTANTIATE_TEST_SUITE_P(All, EverySolid,
                         ::testing::Values(SolidKind::kSphere, SolidKind::kCylinder,
                                           SolidKind::kCone, SolidKind::kBox, SolidKind::kTyre));

TEST(SolidKinds, AreKnownByTheirNames) {
  for (const std::string& name : SolidKindNames())
    EXPECT_TRUE(SolidKindOf(name)) << name;
  EXPECT_FALSE(SolidKindOf("cube"));
}

}  // namespace
}  // namespace limpet
