// SPDX-License-Identifier: MIT
#include "limpet/helm/node_message.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "limpet/helm/act_list.hpp"

namespace limpet {
namespace {

TEST(NodeMessage, NamesTheGroupThatAPostIsForIfThereIsOne) {
  const HelmPost post{.variable = "RETURN", .value = 1.5, .aux = "clock"};
  EXPECT_EQ(NodeMessage({.node = "alpha", .behavior = post.aux}, "blue", post),
            "src_node=alpha,dest_node=all,dest_group=blue,src_app=pHelm,src_bhv=clock,"
            "var_name=RETURN,double_val=1.5");
  EXPECT_EQ(NodeMessage({.node = "alpha", .behavior = post.aux}, "", post),
            "src_node=alpha,dest_node=all,src_app=pHelm,src_bhv=clock,var_name=RETURN,"
            "double_val=1.5");
}

TEST(NodeMessage, TheVehiclesGroupIsWhatItReportsOfItself) {
  VehicleState state;
  HeardValues heard;
  state.heard = &heard;
  EXPECT_EQ(OwnGroup(state), "");
  for (const char* report : {"NAME=alpha,X=1,Y=2,SPD=0,HDG=0,GROUP=blue,TIME=1",
                             R"({"NAME":"alpha","X":1,"Y":2,"SPD":0,"HDG":0,"GROUP":"blue"})"}) {
    heard["NODE_REPORT_LOCAL"] = {Seconds(0.0), std::string(report)};
    EXPECT_EQ(OwnGroup(state), "blue") << report;
  }
  heard["NODE_REPORT_LOCAL"] = {Seconds(0.0), std::string("no report")};
  EXPECT_EQ(OwnGroup(state), "");
}

TEST(NodeMessage, AFlagIsForAllForTheGroupOrForNobodyElse) {
  std::vector<Flag> flags;
  EXPECT_TRUE(AddFlag("#group RETURN = true", flags));
  EXPECT_TRUE(AddFlag("#ALL+ RETURN = true", flags));
  EXPECT_FALSE(AddFlag("#blue RETURN = true", flags));
  const auto has_group = [](const std::string& value) {
    return HasGroupFlag({.key = "runflag", .value = value, .where = {}});
  };
  EXPECT_TRUE(has_group("@cpa #group+ RETURN = true"));
  EXPECT_FALSE(has_group("#all RETURN = true"));
  EXPECT_FALSE(has_group("RETURN = #group"));
}

}  // namespace
}  // namespace limpet
