// SPDX-License-Identifier: MIT
// Which names are those of a variant of a behavior.
#include "limpet/helm/behavior_names.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(BehaviorVariants, AreVersionsAndNamesWithAWordMore) {
  for (const char* name : {"BHV_LoiterV3", "BHV_LoiterX", "BHV_Loiter2", "BHV_Loiter_deep",
                           "BHV_LoiterPT", "BHV_MyLoiter"}) {
    EXPECT_TRUE(IsVariantOfBehavior(name, "BHV_Loiter")) << name;
  }
  EXPECT_TRUE(IsVariantOfBehavior("BHV_OpRegionV25", "BHV_OpRegionV24"));
}

TEST(BehaviorVariants, AreNoSlipsOfThePen) {
  for (const char* name :
       {"BHV_Loiter", "BHV_Loitre", "BHV_Loiters", "BHV_Loitr", "BHV_xLoiter", "Loiter", ""}) {
    EXPECT_FALSE(IsVariantOfBehavior(name, "BHV_Loiter")) << name;
  }
}

}  // namespace
}  // namespace limpet
