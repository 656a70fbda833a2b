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
    EXPECT_EQ(read.domain.speed->low, 0.05);
    EXPECT_NEAR(read.domain.speed->high, speed, 1e-9);
    EXPECT_EQ(read.domain.depth->low, 0.5);
    EXPECT_NEAR(read.domain.depth->high, depth, 1e-9);
  }
}

TEST(MotionDomainLines, AreAskedOfCourseAndSpeed) {
  const DomainRead read = ReadDomain({"depth:0:100:101"});
  ASSERT_THAT(read.problems, SizeIs(2));
  EXPECT_THAT(read.problems[0].text, HasSubstr("`course` is missing"));
  EXPECT_THAT(read.problems[1].text, HasSubstr("`speed` is missing"));
  EXPECT_EQ(read.problems[0].where.line, 1) << "the block's line";
}

TEST(MotionDomainLines, OfASurfaceVehicleLeaveDepthToOthers) {
  const DomainRead read = ReadDomain({"course:0:359:360", "speed:0:4:41"});
  EXPECT_THAT(read.problems, IsEmpty());
  EXPECT_FALSE(read.domain.depth.has_value());
  EXPECT_EQ(read.domain.points(MotionVariable::kDepth), 1);
  EXPECT_EQ(read.domain.points(MotionVariable::kSpeed), 41);
}

TEST(MotionDomainLines, AreReadInTheFormsOfExistingMissions) {
  const DomainRead read =
      ReadDomain({"Course,0,359,360", "speed:0:4.05:delta=0.1", "depth:0:100:101:optional"});
  EXPECT_THAT(read.problems, IsEmpty());
  EXPECT_EQ(read.domain.course->points, 360);
  EXPECT_EQ(read.domain.speed->points, 41);
  EXPECT_DOUBLE_EQ(read.domain.speed->high, 4.0) << "the last point that fits";
  EXPECT_DOUBLE_EQ(read.domain.speed->At(7), 0.7);
  EXPECT_TRUE(read.domain.depth->is_optional);
  EXPECT_FALSE(read.domain.speed->is_optional);
}

TEST(MotionDomainLines, OfOneValueAreOfOnePoint) {
  const DomainRead read = ReadDomain({"course:0:359:360", "speed:0:4:41", "depth:0:0:1"});
  EXPECT_THAT(read.problems, IsEmpty());
  EXPECT_EQ(read.domain.points(MotionVariable::kDepth), 1);
  EXPECT_EQ(read.domain.depth->step(), 0.0);
  EXPECT_EQ(read.domain.depth->At(0), 0.0);
  const std::vector<std::string> lines{"course:0:359:360", "depth:2.5:2.5:1"};
  EXPECT_EQ(MotionDomainText(lines), "depth,2.5,2.5,1:course,0,359,360");
}

TEST(MotionDomainLines, MaySayAnyWordForAVariableThatIsNotOptional) {
  const DomainRead read = ReadDomain({"course:0:359:360:required", "speed:0:4:41:x"});
  EXPECT_THAT(read.problems, IsEmpty());
  EXPECT_FALSE(read.domain.course->is_optional);
  EXPECT_FALSE(read.domain.speed->is_optional);
}

TEST(MotionDomainLines, AreToldAsOneText) {
  const std::vector<std::string> lines{"course:0:359:360", "speed: 0:1:21",
                                       "depth,0,9,10,optional"};
  EXPECT_EQ(MotionDomainText(lines), "depth,0,9,10:speed,0,1,21:course,0,359,360")
      << "the last line first, as MOOS-IvP tells its domain";
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
  EXPECT_EQ(read.domain.speed->high, 1.0) << "the first one counts";
}

class BadDomainLine : public ::testing::TestWithParam<const char*> {};

TEST_P(BadDomainLine, IsRefusedWithItsLine) {
  const DomainRead read = ReadDomain({"course:0:359:360", GetParam(), "depth:0:100:101"});
  ASSERT_THAT(read.problems, SizeIs(1)) << GetParam();
  EXPECT_EQ(read.problems[0].where.line, 6);
  EXPECT_EQ(read.problems[0].key, "domain");
  EXPECT_EQ(read.domain.speed->high, MotionDomain{}.speed->high) << "nothing of it was taken";
}

INSTANTIATE_TEST_SUITE_P(Drawn, BadDomainLine,
                         ::testing::Values("", ":", "speed", "speed:0", "speed:0:1", "speed:1:0:21",
                                           "speed:1:1:21", "speed:1:1:2", "speed:0:x:21",
                                           "speed:0:1:1", "speed:0:1:2.5", "speed:0:1:-4",
                                           "speed:nan:1:21", "speed:0:1:many",
                                           "speed:0:1:21:optionl", "speed:0:1:delta=0",
                                           "speed:0:1:delta=3"));

std::vector<std::string> DomainProblems(const std::vector<std::string>& lines,
                                        MotionDomain& domain) {
  std::vector<ConfigEntry> entries;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    entries.push_back({"domain", lines[i], {"m.moos", 10 + static_cast<int>(i)}});
  }
  std::vector<std::string> texts;
  for (const auto& problem : ReadMotionDomain(entries, {"m.moos", 5}, domain)) {
    texts.push_back(problem.Format());
  }
  return texts;
}

TEST(MotionDomain, IsReadInAnyOrder) {
  MotionDomain domain;
  EXPECT_THAT(
      DomainProblems({"depth:1:50:100", "course:0:359:360", " speed : 0.1 : 2 : 21 "}, domain),
      IsEmpty());
  EXPECT_EQ(domain.speed->low, 0.1);
  EXPECT_EQ(domain.speed->high, 2.0);
  EXPECT_EQ(domain.depth->low, 1.0);
  EXPECT_EQ(domain.depth->high, 50.0);
}

TEST(MotionDomain, NamesFileLineAndWhatIsWrong) {
  const std::vector<std::string> good{"course:0:359:360", "speed:0:1:21", "depth:0:10:11"};
  const auto with = [&good](std::size_t i, const std::string& line) {
    std::vector<std::string> lines = good;
    lines[i] = line;
    MotionDomain domain;
    const auto problems = DomainProblems(lines, domain);
    return problems.empty() ? std::string() : problems[0];
  };
  EXPECT_THAT(with(1, "sped:0:1:21"), HasSubstr("m.moos:11: domain: no decision variable `sped`"));
  EXPECT_THAT(with(1, "sped:0:1:21"), HasSubstr("did you mean `speed`?"));
  EXPECT_THAT(with(2, "depth:10:0:11"), HasSubstr("m.moos:12: domain: `depth:10:0:11`"));
  EXPECT_THAT(with(2, "depth:10:10:11"), HasSubstr("has 11 points; allowed: 1, where low is high"));
  EXPECT_THAT(with(0, "course:90:90:1"), HasSubstr("low below high"));
  EXPECT_THAT(with(2, "depth:0:10:11:optionl"), HasSubstr("did you mean `optional`?"));
  EXPECT_THAT(with(2, "depth:0:10"), HasSubstr("name:low:high:points"));
  EXPECT_THAT(with(2, "depth:0:ten:11"), HasSubstr("name:low:high:points"));
  EXPECT_THAT(with(1, "speed:0:1:1"), HasSubstr("at least 2"));
  EXPECT_THAT(with(1, "speed:0:1:2.5"), HasSubstr("a whole number"));
  EXPECT_THAT(with(1, "course:0:359:360"), HasSubstr("`course` is given twice"));
}

}  // namespace
}  // namespace limpet
