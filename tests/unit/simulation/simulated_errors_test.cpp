// SPDX-License-Identifier: MIT
#include "limpet/simulation/simulated_errors.hpp"

#include <set>

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(SimulatedErrors, SayEveryKeyOnceWithItsRange) {
  SimulatedErrors errors;
  for (const KeySection& section : ErrorSections(errors)) {
    std::set<std::string> names;
    for (const ParamSpec& key : section.keys) {
      EXPECT_TRUE(names.insert(key.name).second) << section.name << " " << key.name;
      EXPECT_NE(key.allowed.find(" to "), std::string::npos) << section.name << " " << key.name;
      EXPECT_FALSE(key.set(key.default_text)) << section.name << " " << key.name;
    }
  }
}

}  // namespace
}  // namespace limpet
