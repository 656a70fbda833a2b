// SPDX-License-Identifier: MIT
// Of an area that is surveyed block by block: one that takes far too long is said to be left.
#include <cmath>
#include <fstream>
#include <memory>
#include <numbers>
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

constexpr double kCircle = 6.0;  ///< radius of what it flies [m]

/// Goes round and round, whatever there is to see.
class BHV_TestRoundabout final : public Behavior {
 public:
  struct Params {
    template <class V>
    void Describe(V&) {}
  };
  explicit BHV_TestRoundabout(const Params&) {}
  [[nodiscard]] bool WantsView() const override { return true; }
  void Offer(const Situation& now, std::vector<Option>& options) const override {
    options.push_back(
        {.source = "round",
         .path = DubinsPath(now.pose, {{.curvature = 1.0 / kCircle, .length = 500.0}})});
  }
  [[nodiscard]] std::optional<Bid> Value(const Prospect&, const Situation&) const override {
    return Bid{};
  }
};
LIMPET_REGISTER_BEHAVIOR(BHV_TestRoundabout);

TEST(HelmOverALargeArea, SaysThatABlockIsLeftThatShowsNothingForAKilometre) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "mission.bhv")
      << "Behavior = BHV_TestRoundabout\n{\n  name = round\n}\n";
  TestLink link;
  AppContext context;
  context.name = "pHelm";
  context.link = &link;
  context.mission_folder = folder.path();
  HelmApp::Params params;
  params.views.generators = "home";
  params.views.replan_every = Meters(100.0);
  HelmApp app(context, params);
  link.Send(app, topics::kSurveyArea,
            SurveyArea{.north_min = 0, .north_max = 150, .east_min = 0, .east_max = 150});
  link.Send(app, topics::kMapLook, ToMapLook(LookModel{}));
  constexpr double kStep = 0.5;  // [m]
  auto fly = [&, flown = 0.0](double metres) mutable {
    for (const double end = flown + metres; flown < end; flown += kStep) {
      const double angle = flown / kCircle;
      link.time += Seconds(1.0);
      link.Send(app, topics::kNavState,
                NavState{.north = 15.0 + kCircle * std::sin(angle),
                         .east = 15.0 + kCircle * (1.0 - std::cos(angle)),
                         .down = 3.0,
                         .yaw = angle,
                         .u = kStep,
                         .altitude = 4.0});
      app.Tick(link.time);
    }
  };
  fly(300.0);
  EXPECT_FALSE(app.warnings().contains("BLOCKS_PASSED_OVER"));
  fly(1500.0);
  EXPECT_TRUE(app.warnings().contains("BLOCKS_PASSED_OVER"));
}

}  // namespace
}  // namespace limpet
