// SPDX-License-Identifier: MIT
#include "limpet/helm/heard_variable.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(HeardVariable, KeepsEachMailOfAnIterationAndTheLastForEver) {
  HeardVariable heard;
  heard.Hear({Seconds(1.0), std::string("one")});
  heard.Hear({Seconds(1.0), std::string("two")});
  ASSERT_EQ(heard.recent().size(), 2u);
  EXPECT_EQ(std::get<std::string>(heard.recent()[0].value), "one");
  EXPECT_EQ(std::get<std::string>(heard.recent()[1].value), "two");
  heard.Settle();
  EXPECT_TRUE(heard.recent().empty());
  EXPECT_EQ(std::get<std::string>(heard.last().value), "two");
}

TEST(HeardVariable, OfAHelmThatIsParkedKeepsTheNewestAndDoesNotGrow) {
  HeardVariable heard;
  for (int i = 0; i < 100'000; ++i) {
    heard.Hear({Seconds(i), static_cast<double>(i)});
  }
  EXPECT_LE(heard.recent().size(), 256u);
  EXPECT_GE(heard.recent().size(), 128u);
  EXPECT_EQ(std::get<double>(heard.recent().back().value), 99'999.0);
  EXPECT_EQ(std::get<double>(heard.recent().front().value),
            100'000.0 - static_cast<double>(heard.recent().size()));
}

}  // namespace
}  // namespace limpet
