// SPDX-License-Identifier: MIT
#include "limpet/sharing/share_address.hpp"

#include <string>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

const MulticastPlan kPlan;

TEST(ShareAddress, BringsBackEveryHostAndPort) {
  Random random(101);
  for (int i = 0; i < 300; ++i) {
    ShareAddress sent;
    for (std::uint64_t n = 1 + random.Index(40); n > 0; --n)
      sent.host += "abcxyz0189.-"[random.Index(12)];
    sent.port = static_cast<std::uint16_t>(random.Index(65536));
    const auto back = ParseShareAddress(sent.Text(), kPlan);
    ASSERT_TRUE(back) << sent.Text();
    EXPECT_EQ(*back, sent);
  }
}

TEST(ShareAddress, EveryChannelHasAPortOfItsOwnInTheOneGroup) {
  for (int channel = 0; channel < kMulticastChannels; ++channel) {
    const auto address = ParseShareAddress("multicast_" + std::to_string(channel), kPlan);
    ASSERT_TRUE(address) << channel;
    EXPECT_EQ(address->channel, channel);
    EXPECT_EQ(address->host, kPlan.group);
    EXPECT_EQ(address->port, kPlan.base_port + channel);
    EXPECT_EQ(address->Text(), "224.1.1.11:" + std::to_string(24460 + channel) + ":multicast_" +
                                   std::to_string(channel));
  }
}

TEST(ShareAddress, BlanksAroundItDoNotMatter) {
  EXPECT_EQ(*ParseShareAddress("  shore:9200 ", kPlan), *ParseShareAddress("shore:9200", kPlan));
  EXPECT_EQ(*ParseShareAddress(" shore :9200", kPlan), *ParseShareAddress("shore:9200", kPlan));
}

TEST(ShareAddress, WhatIsNoAddressIsSaidToBeNoneWithWhatIsAllowed) {
  for (const std::string text : {"", ":", "shore", "shore:", ":9200", "shore:-1", "shore:65536",
                                 "shore:9.5", "shore:x", "sho re:9200", "::1:9200", "a:b:1"}) {
    const auto address = ParseShareAddress(text, kPlan);
    ASSERT_FALSE(address) << text;
    EXPECT_NE(address.error().text.find("host:port or multicast_N"), std::string::npos) << text;
  }
  for (const std::string text :
       {"multicast_", "multicast_256", "multicast_-1", "multicast_1.5", "multicast_x"}) {
    const auto address = ParseShareAddress(text, kPlan);
    ASSERT_FALSE(address) << text;
    EXPECT_NE(address.error().text.find("multicast_255"), std::string::npos) << text;
  }
}

TEST(ShareAddress, AHostIsNoLongerThanADnsName) {
  EXPECT_TRUE(ParseShareAddress(std::string(253, 'h') + ":1", kPlan));
  EXPECT_FALSE(ParseShareAddress(std::string(254, 'h') + ":1", kPlan));
}

}  // namespace
}  // namespace limpet
