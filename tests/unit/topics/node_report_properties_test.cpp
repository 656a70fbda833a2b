// SPDX-License-Identifier: MIT
// What a stock viewer draws of a vehicle is what the vehicle said, as far as its digits go.
#include <cmath>
#include <cstdio>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/config.hpp"
#include "limpet/core/random.hpp"
#include "limpet/topics/viewer.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

NodeReport RandomReport(Random& random) {
  NodeReport report{.name = "alpha",
                    .x = random.Uniform(-1e4, 1e4),
                    .y = random.Uniform(-1e4, 1e4),
                    .speed = random.Uniform(0.0, 3.0),
                    .heading_deg = random.Uniform(0.0, 360.0),
                    .depth = random.Uniform(0.0, 99.0),
                    .latitude_deg = random.Uniform(-90.0, 90.0),
                    .longitude_deg = random.Uniform(-180.0, 180.0),
                    .type = "uuv"};
  report.mode = "MODE@ACTIVE:SURVEYING";
  report.yaw = random.Uniform(-3.1, 3.1);
  report.time = random.Uniform(1e9, 2e9);
  if (random.Chance(0.5)) report.altitude = random.Uniform(0.0, 50.0);
  return report;
}

std::string Sent(const NodeReport& report) {
  return std::get<std::string>(TopicCodec<NodeReport>::Encode(report));
}

TEST(NodeReportText, KeepsPlaceSpeedAndCourseToItsDigits) {
  Random random(1, "reports");
  for (int run = 0; run < 500; ++run) {
    const NodeReport report = RandomReport(random);
    const auto back = TopicCodec<NodeReport>::Decode(Sent(report));
    ASSERT_TRUE(back) << Sent(report);
    EXPECT_NEAR(back->x, report.x, 0.00501);
    EXPECT_NEAR(back->y, report.y, 0.00501);
    EXPECT_NEAR(back->speed, report.speed, 0.00501);
    EXPECT_NEAR(back->heading_deg, report.heading_deg, 0.00501);
    EXPECT_NEAR(*back->latitude_deg, *report.latitude_deg, 5.1e-9) << "a millimetre";
    EXPECT_NEAR(*back->longitude_deg, *report.longitude_deg, 5.1e-9);
    EXPECT_NEAR(*back->yaw, *report.yaw, 5.1e-8);
    EXPECT_NEAR(back->time, report.time, 0.00501);
    EXPECT_EQ(back->altitude.has_value(), report.altitude.has_value());
    EXPECT_EQ(back->mode, report.mode);
  }
}

TEST(NodeReportText, SaysItOnceMoreAsItSaidItBefore) {
  Random random(2, "again");
  for (int run = 0; run < 300; ++run) {
    const std::string text = Sent(RandomReport(random));
    EXPECT_EQ(Sent(*TopicCodec<NodeReport>::Decode(text)), text);
  }
}

TEST(NodeReportText, HasNoNumberWithTrailingZerosOrAMinusZero) {
  Random random(3, "digits");
  for (int run = 0; run < 300; ++run) {
    NodeReport report = RandomReport(random);
    report.x = std::round(report.x * 10.0) / 10.0;
    report.y = -random.Uniform(0.0, 0.004);
    for (const std::string& part : Split(Sent(report), ',')) {
      const std::string value = part.substr(part.find('=') + 1);
      if (value.find('.') != std::string::npos &&
          value.find_first_not_of("-.0123456789") == std::string::npos) {
        EXPECT_NE(value.back(), '0') << part;
      }
      EXPECT_NE(value, "-0") << part;
    }
  }
}

TEST(NodeReportText, LetsNoNameEndAField) {
  NodeReport report{.name = "a,X=9\nb"};
  report.group = "red=blue";
  const std::string text = Sent(report);
  EXPECT_THAT(text, Not(HasSubstr("\n")));
  const auto back = TopicCodec<NodeReport>::Decode(text);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->x, 0.0) << "not the 9 of the name";
  EXPECT_EQ(back->group, "red_blue");
}

TEST(NodeReportText, IsNoneWithoutWhatAViewerNeeds) {
  const std::vector<std::string> parts = Split("NAME=b,X=1,Y=2,SPD=0,HDG=90,TIME=1", ',');
  for (std::size_t lost = 0; lost < parts.size(); ++lost) {
    std::string text;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (i != lost) text += (text.empty() ? "" : ",") + parts[i];
    }
    EXPECT_FALSE(TopicCodec<NodeReport>::Decode(text)) << "without " << parts[lost];
  }
}

}  // namespace
}  // namespace limpet
