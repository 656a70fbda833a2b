// SPDX-License-Identifier: MIT
#include "limpet/recordings/place_columns.hpp"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

std::string TextOf(const std::string& text) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "nav_xy.alog") << text;
  return PlaceColumnsText(folder.path() / "nav_xy.alog");
}

TEST(PlaceColumns, SayTheirPathAndWhatIsMissing) {
  const std::string said = TextOf("0.0\t0.0\n3.0\t4.0\n3.0 10.0\n");
  EXPECT_THAT(said, testing::StartsWith("nav_xy.alog: two columns of 3 numbers"));
  EXPECT_THAT(said, testing::HasSubstr("a path of 11.0 m; missing are time, heading"));
}

TEST(PlaceColumns, AreNothingElse) {
  EXPECT_EQ(TextOf("1.5 NAV_X pNav 3\n"), "");
  EXPECT_EQ(TextOf("1 2\n1 2 3\n"), "");
  EXPECT_EQ(TextOf("1 nan\n2 3\n"), "");
  EXPECT_EQ(TextOf("1 2\n"), "");
  EXPECT_EQ(TextOf(""), "");
}

}  // namespace
}  // namespace limpet
