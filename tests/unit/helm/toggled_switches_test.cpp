// SPDX-License-Identifier: MIT
// `toggle` in a behavior's block and in its updates.
#include "limpet/helm/toggled_switches.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/helm/behavior_host.hpp"
#include "limpet/helm/registry.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Wants 1 m where it is on, else 0.
class BHV_SwitchProbe final : public Behavior {
 public:
  struct Params {
    bool is_on = false, is_bright = true;
    Meters size{1.0};
    template <class V>
    void Describe(V& visit) {
      visit("on", is_on, "Whether it is on");
      visit.Also({"enabled"});
      visit("bright", is_bright, "Whether it is bright");
      visit("size_m", size, "Its size");
    }
  };
  explicit BHV_SwitchProbe(const Params& params) : params_(params) {}
  [[nodiscard]] MotionBid Move(const VehicleState&) override {
    MotionBid bid;
    bid.depth = Peak{.summit = params_.is_on ? 1.0 : 0.0};
    return bid;
  }

 private:
  Params params_;
};
LIMPET_REGISTER_BEHAVIOR(BHV_SwitchProbe);

std::unique_ptr<BehaviorHost> SwitchHost(const std::string& lines) {
  return std::make_unique<BehaviorHost>(std::vector<BehaviorFile>{
      ParseBehaviors("Behavior = BHV_SwitchProbe\n{\n  updates = UP\n" + lines + "}\n", "m.bhv")});
}

bool IsOn(BehaviorHost& host) {
  static_cast<void>(host.Update({}));
  return host.running().at(0).behavior->Move({}).depth->summit > 0.5;
}

std::string SettingsOf(BehaviorHost& host) {
  for (const HelmPost& post : host.Update({})) {
    if (post.variable == "BHV_SETTINGS") return std::get<std::string>(post.value);
  }
  return "";
}

TEST(ToggledSwitch, OfAFileIsTheOtherValueThanTheDefault) {
  EXPECT_FALSE(IsOn(*SwitchHost("")));
  EXPECT_TRUE(IsOn(*SwitchHost("  on = toggle\n")));
  EXPECT_TRUE(IsOn(*SwitchHost("  ENABLED = Toggle\n")));
  EXPECT_FALSE(IsOn(*SwitchHost("  on = toggle\n  enabled = toggle\n"))) << "there and back";
  EXPECT_THAT(SettingsOf(*SwitchHost("  on = toggle\n  bright = toggle\n")),
              HasSubstr("on=true,bright=false"));
}

TEST(ToggledSwitch, OfAnUpdateIsTheOtherValueThanThePresentOne) {
  const auto host = SwitchHost("  on = true\n");
  for (const bool expected : {false, true, false}) {
    host->SetVariable("UP", std::string("on = toggle"));
    EXPECT_EQ(IsOn(*host), expected);
  }
  host->SetVariable("UP", std::string("on = true"));
  host->SetVariable("UP", std::string("size_m = 3 # enabled = toggle # size_m = 2"));
  EXPECT_FALSE(IsOn(*host));
  EXPECT_THAT(host->warnings(), IsEmpty());
}

TEST(ToggledSwitch, OfEveryBehaviorIsDurationIdleDecay) {
  const ConfigBlock block{.name = "BHV_SwitchProbe", .where = {}, .entries = {}};
  const ConfigEntry part{"duration_idle_decay", "toggle", {"m.bhv", 4}};
  const ConfigEntry plain = WithoutToggle(part, block);
  EXPECT_EQ(plain.value, "false") << "the default is true";
  EXPECT_EQ(plain.where.line, 4);
}

TEST(ToggledSwitch, IsNothingElseThatABlockSays) {
  for (const char* line : {"  size_m = toggle\n", "  perpetual = toggle\n", "  om = toggle\n"}) {
    try {
      static_cast<void>(SwitchHost(line));
      ADD_FAILURE() << line;
    } catch (const ConfigError& error) {
      EXPECT_THAT(error.what(), HasSubstr("m.bhv:4: ")) << line;
    }
  }
}

}  // namespace
}  // namespace limpet
