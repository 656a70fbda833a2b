// SPDX-License-Identifier: MIT
#include "estimation/mapping/status_label.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(StatusLabel, EveryDecisionHasItsColourAndWhatIsOpenIsUncertain) {
  EXPECT_EQ(LabelOf(Status::kConfirmed), VoxelLabel::kConfirmed);
  EXPECT_EQ(LabelOf(Status::kRemoved), VoxelLabel::kRemoved);
  EXPECT_EQ(LabelOf(Status::kNew), VoxelLabel::kNew);
  EXPECT_EQ(LabelOf(Status::kMoved), VoxelLabel::kMoved);
  for (const Status open : {Status::kUncertain, Status::kNotInspected, Status::kNothing})
    EXPECT_EQ(LabelOf(open), VoxelLabel::kUncertain);
}

}  // namespace
}  // namespace limpet
