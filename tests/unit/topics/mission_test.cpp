// SPDX-License-Identifier: MIT
#include "limpet/topics/mission.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(ThrusterCommandTopic, SaysTheSeventhAndEighthThrusterWhereThereIsOne) {
  const std::vector<double> shares{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8};
  const auto text = [&](std::size_t count) {
    return EncodeRecord(ThrusterCommand::Of({shares.data(), count}));
  };
  EXPECT_EQ(text(5), "t1=0.1,t2=0.2,t3=0.3,t4=0.4,t5=0.5,t6=0");
  EXPECT_EQ(text(8), "t1=0.1,t2=0.2,t3=0.3,t4=0.4,t5=0.5,t6=0.6,t7=0.7,t8=0.8");
  const auto read = DecodeRecord<ThrusterCommand>(text(8));
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->Shares().at(7), 0.8);
}

}  // namespace
}  // namespace limpet
