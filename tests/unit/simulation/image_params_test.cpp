// SPDX-License-Identifier: MIT
#include "limpet/simulation/image_params.hpp"

#include <set>

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(ImageParams, SayEveryKeyOnceWithItsRange) {
  ImageParams image;
  for (const KeySection& section : ImageSections(image)) {
    std::set<std::string> names;
    for (const ParamSpec& key : section.keys) {
      EXPECT_TRUE(names.insert(key.name).second) << section.name << " " << key.name;
      EXPECT_FALSE(key.allowed.empty()) << section.name << " " << key.name;
      EXPECT_FALSE(key.set(key.default_text)) << section.name << " " << key.name;
    }
  }
}

TEST(ImageParams, ArePlainUnlessAskedFor) { EXPECT_EQ(ImageParams{}.look, "plain"); }

}  // namespace
}  // namespace limpet
