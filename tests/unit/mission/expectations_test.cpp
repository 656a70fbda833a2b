// SPDX-License-Identifier: MIT
#include "limpet/mission/expectations.hpp"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using testing::HasSubstr;

Expectations Parse(const std::string& text) {
  return ParseExpectations(text, "expect.yaml", {"discovery", "change"});
}

std::string ComplaintAbout(const std::string& text) {
  try {
    static_cast<void>(Parse(text));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "none";
}

TEST(Expectations, KeepsEachBoundWithItsLine) {
  const Expectations expected =
      Parse("each:\n  covered: {min: 0.9}\nchange:\n  missed: {max: 0}\n");
  ASSERT_EQ(expected.sessions.size(), 2U);
  EXPECT_EQ(expected.sessions[1].session, "change");
  ASSERT_EQ(expected.sessions[1].bounds.size(), 1U);
  EXPECT_EQ(expected.sessions[1].bounds[0].max, 0.0);
  EXPECT_EQ(expected.sessions[1].bounds[0].min, std::nullopt);
  EXPECT_EQ(expected.sessions[1].bounds[0].where.line, 4);
}

TEST(Expectations, NamesTheNearestKeyOfAMisspeltOne) {
  EXPECT_THAT(ComplaintAbout("each:\n  home_eror_m: {max: 3}\n"),
              AllOf(HasSubstr("expect.yaml:2"), HasSubstr("did you mean `home_error_m`")));
}

TEST(Expectations, RefuseASessionThatTheMissionLacks) {
  EXPECT_THAT(ComplaintAbout("chnage:\n  missed: {max: 0}\n"), HasSubstr("did you mean `change`"));
}

TEST(Expectations, RefuseABoundThatNoNumberKeeps) {
  EXPECT_THAT(ComplaintAbout("each:\n  covered: {min: 1, max: 0.5}\n"),
              HasSubstr("min 1 is above max 0.5"));
  EXPECT_THAT(ComplaintAbout("each:\n  covered: {}\n"), HasSubstr("needs a min or a max"));
}

TEST(Expectations, RefuseAnEndThatASessionCannotHave) {
  EXPECT_THAT(ComplaintAbout("each:\n  ended: hom\n"), HasSubstr("expect.yaml:2"));
}

TEST(Expectations, OfAnotherVehicleAreInAFileOfItsName) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "expect.yaml") << "each:\n  path_m: {max: 500}\n";
  std::ofstream(folder.path() / "expect.bluerov2.yaml") << "each:\n  path_m: {max: 900}\n";
  const auto limit_of = [&folder](const std::string& vehicle) {
    const auto expected = LoadExpectations(folder.path(), Scenario{}, vehicle);
    return expected->sessions.front().bounds.front().max;
  };
  EXPECT_EQ(limit_of("bluerov2.yaml"), 900.0);
  EXPECT_EQ(limit_of("vehicles/bluerov2.yaml"), 900.0);
  EXPECT_EQ(limit_of("feelhippo.yaml"), 500.0);
  EXPECT_EQ(limit_of(""), 500.0);
  EXPECT_EQ(LoadExpectations(folder.path(), Scenario{}, "bluerov2.yaml")->file,
            "expect.bluerov2.yaml");
}

}  // namespace
}  // namespace limpet
