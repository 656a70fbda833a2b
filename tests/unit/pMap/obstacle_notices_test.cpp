// SPDX-License-Identifier: MIT
#include "apps/pMap/obstacle_notices.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const Obstacle kNoticed{.id = 3, .outline = {{1.0, 2.0}, {1.0, 3.0}, {2.0, 3.0}}, .top = 0.4};

TEST(ObstacleNotices, AreWhatMoosIvpsBehaviorsAreSpawnedBy) {
  ObstacleNotices notices;
  const auto news = notices.Of({kNoticed});
  EXPECT_THAT(news.alerts,
              ElementsAre("name=ob_3#poly=pts={2.00,1.00:3.00,1.00:3.00,2.00},label=ob_3#id=ob_3"));
  EXPECT_THAT(news.found, ElementsAre("ob_3 stands about 1.3 north, 2.7 east, up to 0.4 m deep"));
}

TEST(ObstacleNotices, SayNothingTwiceAndWhatHasGoneOnce) {
  ObstacleNotices notices;
  static_cast<void>(notices.Of({kNoticed}));
  const auto same = notices.Of({kNoticed});
  EXPECT_THAT(same.alerts, IsEmpty());
  EXPECT_THAT(same.resolved, IsEmpty());
  Obstacle grown = kNoticed;
  grown.outline[2] = {4.0, 3.0};
  const auto other = notices.Of({grown});
  EXPECT_EQ(other.alerts.size(), 1U);
  EXPECT_THAT(other.found, IsEmpty());
  EXPECT_THAT(notices.Of({}).resolved, ElementsAre("ob_3"));
  EXPECT_THAT(notices.Of({}).resolved, IsEmpty());
}

}  // namespace
}  // namespace limpet
