// SPDX-License-Identifier: MIT
// What a helm says of its decisions: that it has no way to go left, and how long one took.
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "apps/pHelm/helm_app.hpp"
#include "limpet/core/clock.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/survey/look.hpp"
#include "limpet/topics/viewer.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

/// Wants views and offers to go ahead, but forbids that while the vehicle is south of the middle.
class BHV_TestForbid final : public Behavior {
 public:
  struct Params {
    template <class V>
    void Describe(V&) {}
  };
  explicit BHV_TestForbid(const Params&) {}
  [[nodiscard]] bool WantsView() const override { return true; }
  void Offer(const Situation& now, std::vector<Option>& options) const override {
    options.push_back(
        {.source = "ahead", .path = DubinsPath(now.pose, {{.curvature = 0.0, .length = 3.0}})});
  }
  [[nodiscard]] std::optional<Bid> Value(const Prospect&, const Situation& now) const override {
    Bid bid;
    if (now.pose.north < 0.0) {
      bid.veto = "too far south";
    }
    return bid;
  }
};
LIMPET_REGISTER_BEHAVIOR(BHV_TestForbid);

/// Forbids everything, but thinks half a second too long about it.
class BHV_TestBrooder final : public Behavior {
 public:
  struct Params {
    template <class V>
    void Describe(V&) {}
  };
  explicit BHV_TestBrooder(const Params&) {}
  [[nodiscard]] std::optional<Bid> Value(const Prospect&, const Situation&) const override {
    const Seconds begin = SteadyTime();
    while (SteadyTime() - begin < Seconds(0.52)) {
    }
    Bid bid;
    bid.veto = "on the other hand";
    return bid;
  }
};
LIMPET_REGISTER_BEHAVIOR(BHV_TestBrooder);

/// A helm that decides where next over an area.
class DecidingHelm {
 public:
  explicit DecidingHelm(bool runs_live, const std::string& more = "") {
    std::ofstream(folder_.path() / "mission.bhv")
        << "Behavior = BHV_TestForbid\n{\n  name = no\n}\n"
        << more;
    AppContext context;
    context.name = "pHelm";
    context.link = &link_;
    context.mission_folder = folder_.path();
    context.runs_live = runs_live;
    app_ = std::make_unique<HelmApp>(context, HelmApp::Params{});
    link_.Send(*app_, topics::kSurveyArea,
               SurveyArea{.north_min = -10, .north_max = 10, .east_min = -10, .east_max = 10});
    link_.Send(*app_, topics::kMapLook, ToMapLook(LookModel{}));
  }
  void StayAt(double north, int ticks = 100) {
    for (int tick = 0; tick < ticks; ++tick) {
      link_.time += Seconds(0.1);
      link_.Send(*app_, topics::kNavState,
                 NavState{.north = north, .east = 0.0, .down = 3.0, .u = 0.5, .altitude = 4.0});
      app_->Tick(link_.time);
    }
  }
  [[nodiscard]] bool Warns(const std::string& id = "NO_OPTION") const {
    return app_->warnings().contains(id);
  }
  [[nodiscard]] const TestLink& link() const { return link_; }

 private:
  TemporaryFolder folder_;
  TestLink link_;
  std::unique_ptr<HelmApp> app_;
};

TEST(HelmWithoutOptions, WarnsUntilItFindsOne) {
  DecidingHelm helm(false);
  helm.StayAt(-5.0);
  EXPECT_TRUE(helm.Warns());
  helm.StayAt(5.0);
  EXPECT_FALSE(helm.Warns());
}

TEST(HelmThatDecides, SaysInACommunityHowLongThatTook) {
  DecidingHelm live(true), embedded(false);
  live.StayAt(5.0);
  embedded.StayAt(5.0);
  EXPECT_GT(live.link().Count(topics::kHelmBids), 0);
  EXPECT_EQ(live.link().Count(topics::kPlanTime), live.link().Count(topics::kHelmBids));
  EXPECT_GT(live.link().Last(topics::kPlanTime).value(), 0.0);
  EXPECT_LT(live.link().Last(topics::kPlanTime).value(), 10.0);
  EXPECT_EQ(embedded.link().Count(topics::kPlanTime), 0) << "equal runs say the same";
  const double create = live.link().Last(topics::kHelmCreateTime).value();
  EXPECT_GT(create, 0.0);
  EXPECT_GT(live.link().Last(topics::kHelmLoopTime).value(), create);
  EXPECT_EQ(embedded.link().Count(topics::kHelmCreateTime), 0);
  EXPECT_EQ(embedded.link().Count(topics::kHelmLoopTime), 0);
}

TEST(HelmThatDecides, DoesNotHearInACommunityWhoTakesTooLongOverWhereNextAndSaysSo) {
  const std::string brooder = "Behavior = BHV_TestBrooder\n{\n  name = brooder\n}\n";
  DecidingHelm live(true, brooder), embedded(false, brooder);
  constexpr int kTicks = 25;
  live.StayAt(5.0, kTicks);
  EXPECT_TRUE(live.Warns("BHV_LATE_brooder"));
  EXPECT_FALSE(live.Warns()) << "its veto is not heard";
  embedded.StayAt(5.0, kTicks);
  EXPECT_FALSE(embedded.Warns("BHV_LATE_brooder"));
  EXPECT_TRUE(embedded.Warns()) << "runs repeat, however fast the machine is";
}

}  // namespace
}  // namespace limpet
