// SPDX-License-Identifier: MIT
#include "limpet/imaging/clutter.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace limpet {
namespace {

struct Found {
  std::vector<Growth> growth;
  std::vector<Solid> litter;
};

Found In(const Clutter::Area& area, Clutter::Density density, std::uint64_t seed = 4) {
  SeabedRelief relief([](const Eigen::Vector2d& p_W) { return 7.0 + 0.01 * p_W.x(); });
  Found found;
  Clutter(density, seed).Collect(area, relief, found.growth, found.litter);
  return found;
}

constexpr Clutter::Area kHectare{-50.0, 50.0, -50.0, 50.0};

TEST(Clutter, IsAsDenseAsAskedFor) {
  const Found found = In(kHectare, {.natural_per_m2 = 0.4, .litter_per_m2 = 0.02});
  EXPECT_NEAR(static_cast<double>(found.growth.size()), 4000.0, 200.0);  // 3 sigma
  EXPECT_NEAR(static_cast<double>(found.litter.size()), 200.0, 45.0);
}

TEST(Clutter, LiesWhereItLiesWhoeverLooks) {
  const Found all = In(kHectare, {0.3, 0.1});
  const Found some = In({2.3, 4.1, -7.9, -3.0}, {0.3, 0.1});
  ASSERT_FALSE(some.growth.empty());
  for (const Growth& one : some.growth) {
    EXPECT_EQ(std::ranges::count_if(all.growth,
                                    [&one](const Growth& other) {
                                      return one.north == other.north && one.east == other.east &&
                                             one.radius == other.radius && one.kind == other.kind;
                                    }),
              1);
  }
}

TEST(Clutter, DiffersWithTheSeed) {
  EXPECT_NE(In(kHectare, {0.3, 0.0}, 1).growth.front().north,
            In(kHectare, {0.3, 0.0}, 2).growth.front().north);
}

TEST(Clutter, LitterLiesOnTheSeabed) {
  for (const Solid& one : In(kHectare, {0.0, 0.05}).litter) {
    const double seabed = 7.0 + 0.01 * one.p_W.x();
    EXPECT_GT(one.p_W.z() + one.ReachDown(), seabed);  // touches it
    EXPECT_LT(one.p_W.z() - one.ReachDown(), seabed);  // and stands out
  }
}

TEST(Clutter, OfNoDensityIsNone) {
  EXPECT_TRUE(In(kHectare, {}).growth.empty());
  EXPECT_TRUE(In(kHectare, {}).litter.empty());
}

}  // namespace
}  // namespace limpet
