// SPDX-License-Identifier: MIT
// A helm in flight finds behaviors by the names that missions write.
#include <gtest/gtest.h>

#include "limpet/helm/registry.hpp"

namespace limpet {
namespace {

TEST(BehaviorRegistry, HoldsEveryBehaviorOfThisFolder) {
  for (const char* name :
       {"BHV_ConstantDepth", "BHV_CoverArea", "BHV_FollowPath", "BHV_HoldAltitude",
        "BHV_HoldStation", "BHV_OpRegion", "BHV_ReduceMapEntropy", "BHV_ReduceObjectEntropy",
        "BHV_ReturnHome", "BHV_RevisitOpi"}) {
    EXPECT_TRUE(BehaviorRegistry().contains(name)) << name;
  }
}

}  // namespace
}  // namespace limpet
