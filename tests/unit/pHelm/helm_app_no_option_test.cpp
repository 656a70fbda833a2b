// SPDX-License-Identifier: MIT
// A helm that is left without any way to go says so, and that it has found one.
#include <fstream>
#include <memory>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "apps/pHelm/helm_app.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/survey/look.hpp"
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

TEST(HelmWithoutOptions, WarnsUntilItFindsOne) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "mission.bhv") << "Behavior = BHV_TestForbid\n{\n  name = no\n}\n";
  TestLink link;
  AppContext context;
  context.name = "pHelm";
  context.link = &link;
  context.mission_folder = folder.path();
  HelmApp app(context, HelmApp::Params{});
  link.Send(app, topics::kSurveyArea,
            SurveyArea{.north_min = -10, .north_max = 10, .east_min = -10, .east_max = 10});
  link.Send(app, topics::kMapLook, ToMapLook(LookModel{}));
  const auto stay_at = [&](double north) {
    for (int tick = 0; tick < 100; ++tick) {
      link.time += Seconds(0.1);
      link.Send(app, topics::kNavState,
                NavState{.north = north, .east = 0.0, .down = 3.0, .u = 0.5, .altitude = 4.0});
      app.Tick(link.time);
    }
  };
  stay_at(-5.0);
  EXPECT_TRUE(app.warnings().contains("NO_OPTION"));
  stay_at(5.0);
  EXPECT_FALSE(app.warnings().contains("NO_OPTION"));
}

}  // namespace
}  // namespace limpet
