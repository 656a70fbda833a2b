// SPDX-License-Identifier: MIT
#include "limpet/core/factory_registry.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

FactoryRegistry<int> TwoLamps() {
  FactoryRegistry<int> registry("lamp");
  registry.Add("strobe", [] { return std::make_unique<int>(2); });
  registry.Add("beam", [] { return std::make_unique<int>(1); });
  return registry;
}

TEST(FactoryRegistry, ListsNamesInAlphabeticalOrder) {
  EXPECT_THAT(TwoLamps().Names(), ::testing::ElementsAre("beam", "strobe"));
}

TEST(FactoryRegistry, MakesANewFactoryEachTime) {
  const FactoryRegistry<int> registry = TwoLamps();
  **registry.Find("strobe") = 7;
  EXPECT_EQ(**registry.Find("strobe"), 2);
}

TEST(FactoryRegistry, NamesTheNearestOfAMisspeltName) {
  EXPECT_EQ(TwoLamps().Find("strobo").error().text, "no lamp `strobo`; did you mean `strobe`?");
  EXPECT_EQ(TwoLamps().Find("sun_dial").error().text, "no lamp `sun_dial`");
}

TEST(FactoryRegistryDeathTest, TwoOfOneNameAreABug) {
  FactoryRegistry<int> registry = TwoLamps();
  EXPECT_DEATH(registry.Add("beam", [] { return nullptr; }), "two lamps are registered as beam");
}

TEST(FactoryRegistry, NamesAreLowerCaseWords) {
  static_assert(IsLowerCaseName("color_shape") && IsLowerCaseName("net2"));
  static_assert(!IsLowerCaseName("") && !IsLowerCaseName("ColorShape") && !IsLowerCaseName("2_d") &&
                !IsLowerCaseName("a b"));
}

}  // namespace
}  // namespace limpet
