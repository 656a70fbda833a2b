// SPDX-License-Identifier: MIT
#include "limpet/helm/motion_domain.hpp"

#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

struct DomainRead {
  MotionDomain domain;
  std::vector<ConfigProblem> problems;
};

DomainRead ReadDomain(const std::vector<std::string>& lines) {
  std::vector<ConfigEntry> entries;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    entries.push_back({.key = "domain",
                       .value = lines[i],
                       .where = {.file = "a.moos", .line = static_cast<int>(i) + 5}});
  }
  DomainRead read;
  read.problems = ReadMotionDomain(entries, {.file = "a.moos", .line = 1}, read.domain);
  return read;
}

TEST(MotionDomainLines, SayTheBoundsOfSpeedAndDepth) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const double speed = random.Uniform(0.1, 3.0), depth = random.Uniform(1.0, 300.0);
    const DomainRead read = ReadDomain({"course:0:359:360", fmt::format("speed:0.05:{}:21", speed),
                                        fmt::format(" depth : 0.5 : {} : 101 ", depth)});
    ASSERT_THAT(read.problems, IsEmpty());
    EXPECT_EQ(read.domain.speed_low, 0.05);
    EXPECT_NEAR(read.domain.speed_high, speed, 1e-9);
    EXPECT_EQ(read.domain.depth_low, 0.5);
    EXPECT_NEAR(read.domain.depth_high, depth, 1e-9);
  }
}

TEST(MotionDomainLines, AreAllThreeAsked) {
  const DomainRead read = ReadDomain({"course:0:359:360"});
  ASSERT_THAT(read.problems, SizeIs(2));
  EXPECT_THAT(read.problems[0].text, HasSubstr("`speed` is missing"));
  EXPECT_THAT(read.problems[1].text, HasSubstr("`depth` is missing"));
  EXPECT_EQ(read.problems[0].where.line, 1) << "the block's line";
}

TEST(MotionDomainLines, WithAnUnknownNameAreComplainedAboutOnceWithTheNearestName) {
  const DomainRead read = ReadDomain({"course:0:359:360", "sped:0:1:21", "depth:0:100:101"});
  ASSERT_THAT(read.problems, SizeIs(1)) << "not also that speed is missing";
  EXPECT_THAT(read.problems[0].text, HasSubstr("did you mean `speed`?"));
  EXPECT_EQ(read.problems[0].where.line, 6);
}

TEST(MotionDomainLines, GivenTwiceAreRefused) {
  const DomainRead read =
      ReadDomain({"course:0:359:360", "speed:0:1:21", "depth:0:100:101", "speed:0:2:21"});
  ASSERT_THAT(read.problems, SizeIs(1));
  EXPECT_THAT(read.problems[0].text, HasSubstr("`speed` is given twice"));
  EXPECT_EQ(read.domain.speed_high, 1.0) << "the first one counts";
}

class BadDomainLine : public ::testing::TestWithParam<const char*> {};

TEST_P(BadDomainLine, IsRefusedWithItsLine) {
  const DomainRead read = ReadDomain({"course:0:359:360", GetParam(), "depth:0:100:101"});
  ASSERT_THAT(read.problems, SizeIs(1)) << GetParam();
  EXPECT_EQ(read.problems[0].where.line, 6);
  EXPECT_EQ(read.problems[0].key, "domain");
  EXPECT_EQ(read.domain.speed_high, MotionDomain{}.speed_high) << "nothing of it was taken";
}

INSTANTIATE_TEST_SUITE_P(Drawn, BadDomainLine,
                         ::testing::Values("", ":", "speed", "speed:0", "speed:0:1", "speed:1:0:21",
                                           "speed:1:1:21", "speed:0:x:21", "speed:0:1:1",
                                           "speed:0:1:2.5", "speed:0:1:-4", "speed:nan:1:21",
                                           "speed:0:1:many"));

}  // namespace
}  // namespace limpet
