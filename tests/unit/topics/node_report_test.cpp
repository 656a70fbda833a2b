// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "limpet/topics/viewer.hpp"

namespace limpet {
namespace {

using Codec = TopicCodec<NodeReport>;

TEST(NodeReport, IsWrittenAsTheStockReporterWritesIt) {
  const NodeReport report{.name = "alpha",
                          .x = 0.0,
                          .y = -20.0,
                          .speed = 0.0,
                          .heading_deg = 180.0,
                          .depth = 0.0,
                          .latitude_deg = 43.82511993,
                          .longitude_deg = -70.33039599,
                          .type = "kayak",
                          .color = "yellow",
                          .group = "",
                          .mode = "PARK",
                          .allstop = "ManualOverride",
                          .altitude = {},
                          .yaw = -1.5707963,
                          .time = 17952458619.39,
                          .length = 4.0,
                          .beam = {}};
  EXPECT_EQ(std::get<std::string>(Codec::Encode(report)),
            "NAME=alpha,X=0,Y=-20,SPD=0,HDG=180,DEP=0,LAT=43.82511993,LON=-70.33039599,TYPE=kayak,"
            "COLOR=yellow,MODE=PARK,ALLSTOP=ManualOverride,YAW=-1.5707963,TIME=17952458619.39,"
            "LENGTH=4");
  EXPECT_EQ(Codec::Decode(Codec::Encode(report)), report);
}

TEST(NodeReport, IsReadInEitherCaseAndWithAliases) {
  const auto report = Codec::Decode(
      std::string("name=b, x=1.5,y=2,speed=0.5,heading=90,depth=3,utc_time=12,len=1.3,other=7"));
  ASSERT_TRUE(report);
  EXPECT_EQ(report->name, "b");
  EXPECT_EQ(report->speed, 0.5);
  EXPECT_EQ(report->depth, 3.0);
  EXPECT_EQ(report->length, 1.3);
}

TEST(NodeReport, WithoutNameOrPlaceIsNone) {
  EXPECT_FALSE(Codec::Decode(std::string("NAME=b,X=1,SPD=0,HDG=0,TIME=1")));
  EXPECT_FALSE(Codec::Decode(std::string("X=1,Y=2,SPD=0,HDG=0,TIME=1")));
  EXPECT_FALSE(Codec::Decode(Value(1.0)));
}

}  // namespace
}  // namespace limpet
