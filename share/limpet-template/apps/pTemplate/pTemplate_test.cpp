#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "limpet/app/embedded.hpp"

namespace {

/// What pTemplate says at a depth, in a community of its own on virtual time.
std::string SaidAt(double depth) {
  limpet::EmbeddedSetup setup;
  setup.community = "test";
  setup.apps = {"pTemplate"};
  limpet::EmbeddedCommunity community(setup);
  community.Poke("NAV_DEPTH", depth);
  community.Step();
  return std::get<std::string>(community.database().Latest("PTEMPLATE_TOO_DEEP")->value);
}

TEST(pTemplate, WarnsBelowItsLimit) {
  EXPECT_EQ(SaidAt(10.0), "false");
  EXPECT_EQ(SaidAt(60.0), "true");
}

}  // namespace
