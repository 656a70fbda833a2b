// SPDX-License-Identifier: MIT
// An object of which no look ever tells anything: the helm, with the behaviors of a mission, must
// not fly over it for ever.
#include <cmath>
#include <filesystem>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/pHelm/helm_app.hpp"
#include "limpet/core/frames.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

/// The struct's own values, but lower and with a quicker search.
HelmApp::Params ParamsOfTheTest() {
  HelmApp::Params params;
  const ConfigBlock block{.name = "pHelm",
                          .where = {},
                          .entries = {{.key = "survey_altitude_m", .value = "3", .where = {}},
                                      {.key = "beam_width", .value = "10", .where = {}}}};
  // What a mission must say besides is no matter here.
  static_cast<void>(ApplyBlock(block, DescribeParams(params)));
  return params;
}

/// The basin's helm and a vehicle that does at once what it asks for.
class FruitlessLooksTest : public ::testing::Test {
 protected:
  FruitlessLooksTest() {
    AppContext context;
    context.name = "pHelm";
    context.link = &link_;
    context.mission_folder = fs::path(LIMPET_SOURCE_DIR) / "missions" / "basin";
    context.globals = {{.key = "survey_altitude_m", .value = "3", .where = {}}};
    app_ = std::make_unique<HelmApp>(context, ParamsOfTheTest());
    object_.id = 4;
    object_.object.p_W = {3.0, 3.0, 5.0};
    object_.object.cov_W = 0.04 * Eigen::Matrix3d::Identity();
    object_.posterior = {.confirmed = 0.5, .removed = 0.5};
    link_.Send(*app_, topics::kSurveyArea,
               SurveyArea{.north_min = -10, .north_max = 10, .east_min = -10, .east_max = 10});
    link_.Send(*app_, topics::kMapLook, ToMapLook(LookModel{}));
    link_.Send(*app_, topics::kManualOverride, false);
    link_.Send(*app_, topics::kDeploy, true);
    link_.Send(*app_, topics::kSurveyPhase, std::string("SURVEY"));
    // As the helm itself says at the start.
    app_->Deliver(std::make_shared<const Message>(Message{.name = "SURFACE_FIX",
                                                          .value = std::string("false"),
                                                          .time = link_.time,
                                                          .source = "pHelm",
                                                          .source_aux = "",
                                                          .community = ""}));
    link_.Send(*app_, topics::kMapOpis, OpiBeliefs{{object_}});
  }

  void Sail(double metres) {
    constexpr double kStep = 0.1;  // [s]
    for (double sailed = 0.0; sailed < metres; sailed += 0.5 * kStep) {
      link_.time += Seconds(kStep);
      link_.Send(*app_, topics::kNavState, nav_);
      app_->Tick(link_.time);
      if (const auto heading = link_.Last(topics::kDesiredHeading)) {
        nav_.yaw = YawFromMoosHeading(*heading);
        nav_.north += 0.5 * kStep * std::cos(nav_.yaw);
        nav_.east += 0.5 * kStep * std::sin(nav_.yaw);
        nearest_ = std::min(nearest_, std::hypot(nav_.north - 3.0, nav_.east - 3.0));
      }
    }
  }
  [[nodiscard]] double Elapsed() const { return (link_.time - start_).value(); }
  [[nodiscard]] RevisitInterest Interest() const {
    const auto told = link_.Last(topics::kHelmRevisits);
    return told && !told->objects.empty() ? told->objects.front() : RevisitInterest{};
  }

  TestLink link_;
  Seconds start_ = link_.time;
  std::unique_ptr<HelmApp> app_;
  OpiBelief object_;
  NavState nav_{.north = -8.0, .east = -8.0, .down = 3.0, .u = 0.5, .altitude = 3.0};
  double nearest_ = 1e9;
};

TEST_F(FruitlessLooksTest, HalveTheWorthUntilTheObjectIsGivenUp) {
  Sail(0.1);
  EXPECT_EQ(Interest().state, "open");
  const double worth = Interest().worth;
  while (Interest().fruitless == 0 && Elapsed() < 2000.0) {
    Sail(1.0);
  }
  EXPECT_NEAR(Interest().worth, 0.5 * worth, 1e-9);
  EXPECT_LT(nearest_, 1.5);  // it did go there
  while (Interest().state == "open" && Elapsed() < 4000.0) {
    Sail(1.0);
  }
  EXPECT_EQ(Interest().state, "given_up");
  EXPECT_TRUE(app_->warnings().contains("OBJECTS_GIVEN_UP"));
  EXPECT_DOUBLE_EQ(Interest().worth, 0.0);
}

TEST_F(FruitlessLooksTest, AreSaidInTheBids) {
  while (Interest().fruitless == 0 && Elapsed() < 2000.0) {
    Sail(1.0);
  }
  Sail(10.0);
  const HelmBids bids = link_.Last(topics::kHelmBids).value_or(HelmBids{});
  std::string whys;
  for (const BiddenOption& option : bids.options) {
    for (const WeightedBid& weighted : option.bids) {
      whys += WhyText(weighted.bid) + "\n";
    }
  }
  EXPECT_THAT(whys, testing::HasSubstr("fruitless_looks=1.00"));
}

TEST_F(FruitlessLooksTest, ANewBeliefMakesTheObjectWorthLooksAgain) {
  while (Interest().fruitless == 0 && Elapsed() < 2000.0) {
    Sail(1.0);
  }
  object_.looks = 1;
  link_.Send(*app_, topics::kMapOpis, OpiBeliefs{{object_}});
  Sail(0.1);
  EXPECT_EQ(Interest().fruitless, 0);
}

TEST_F(FruitlessLooksTest, AnObjectBeyondTheRegionsReachIsNotWaitedFor) {
  object_.object.p_W = {18.0, 0.0, 5.0};
  link_.Send(*app_, topics::kMapOpis, OpiBeliefs{{object_}});
  Sail(0.1);
  EXPECT_EQ(Interest().state, "out_of_reach");
  EXPECT_TRUE(app_->warnings().contains("OBJECTS_OUT_OF_REACH"));
}

}  // namespace
}  // namespace limpet
