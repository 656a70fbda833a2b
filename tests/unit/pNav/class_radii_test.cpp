// SPDX-License-Identifier: MIT
#include "apps/pNav/class_radii.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;

TEST(ClassRadii, AreNamedAfterTheirClass) {
  EXPECT_THAT(*ParseClassRadii("yellow:0.5, orange : 0.3"),
              ElementsAre(Pair("orange", 0.3), Pair("yellow", 0.5)));
  EXPECT_THAT(*ParseClassRadii("none"), IsEmpty());
}

TEST(ClassRadii, WhatIsNoRadiusIsNamed) {
  for (const char* text :
       {"yellow", "yellow:", ":0.5", "yellow:-1", "yellow:wide", "yellow:0.5,", "yellow:1e9", ""}) {
    EXPECT_FALSE(ParseClassRadii(text)) << text;
  }
  EXPECT_THAT(ParseClassRadii("yellow:0.5, orange:big").error().text, HasSubstr("`orange:big`"));
  EXPECT_THAT(ParseClassRadii("a:1, a:2").error().text, HasSubstr("`a`"));
}

}  // namespace
}  // namespace limpet
