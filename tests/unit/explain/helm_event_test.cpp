// SPDX-License-Identifier: MIT
#include "limpet/explain/helm_event.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

std::string TextOf(const LoggedWord& word) {
  HelmEvents events;
  events.Take(word, 1.0);
  if (events.events().empty()) return "";
  const HelmEvent& event = events.events()[0];
  return event.who + " " + event.what;
}

TEST(HelmEvents, AreModesLivesAndWaypoints) {
  EXPECT_EQ(TextOf({"MODE", "HELM_MODE", "ACTIVE:GO"}), "MODE = ACTIVE:GO");
  EXPECT_EQ(TextOf({"MODE", "", "ACTIVE:GO"}), "") << "not the helm's";
  EXPECT_EQ(TextOf({"IVPHELM_LIFE_EVENT", "",
                    "iter=0,time=138.64, bname=det_one, btype=BHV_Waypoint, event=spawn, "
                    "seed=name=one # points=0,-25:0,-30,iter=1388"}),
            "det_one began");
  EXPECT_EQ(TextOf({"IVPHELM_LIFE_EVENT", "",
                    "iter=0,time=221.74, bname=slow, btype=BHV_ConstantSpeed, event=death, "
                    "post_mortem=completed-byduration,iter=2219"}),
            "slow ended: completed-byduration");
  EXPECT_EQ(TextOf({"IVPHELM_LIFE_EVENT", "", "broken"}), "");
  EXPECT_EQ(TextOf({"WPT_INDEX", "lap", "2.00000"}), "lap on to waypoint 2");
  EXPECT_EQ(TextOf({"WPT_STAT", "lap", "behavior-name=lap,completed"}), "lap completed");
  EXPECT_EQ(TextOf({"WPT_STAT", "lap", "vname=alpha,behavior-name=lap,index=2"}), "");
}

TEST(HelmEvents, AreFoundByTheirTime) {
  HelmEvents events;
  events.Take({"WPT_INDEX", "lap", "0"}, 1.0);
  events.Take({"WPT_INDEX", "lap", "1"}, 2.0);
  events.Take({"WPT_INDEX", "lap", "2"}, 1.9);
  EXPECT_EQ(events.Between({1.0, 2.0}).size(), 2U) << "one that came late counts as of then";
  EXPECT_TRUE(events.Between({2.0, 1.0}).empty());
}

}  // namespace
}  // namespace limpet
