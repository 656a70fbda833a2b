// SPDX-License-Identifier: MIT
// Blocks written for MOOS-IvP's app of this name, which limpet launch finds ours for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/pNodeReporter/node_reporter_app.hpp"
#include "limpet/app/registry.hpp"
#include "limpet/mission/mission_file.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

ConfigBlock StockBlock(const std::string& lines) {
  const MissionFile mission =
      ParseMission("ProcessConfig = pNodeReporter\n{\n" + lines + "}\n", "stock.moos");
  return *mission.Block("pNodeReporter");
}

std::vector<std::string> ComplaintsAbout(const std::string& lines) {
  std::vector<std::string> complaints;
  for (const ConfigProblem& problem : AppRegistry().at("pNodeReporter").check(StockBlock(lines))) {
    complaints.push_back(problem.Format());
  }
  return complaints;
}

/// An app with a stock block's lines, that knows where it is.
class StockReporter {
 public:
  explicit StockReporter(const std::string& lines) {
    context_.name = "pNodeReporter";
    context_.link = &link_;
    context_.globals = {{"Community", "alpha", {}}};
    app_ = AppRegistry().at("pNodeReporter").create(context_, StockBlock(lines));
    for (const char* name : {"NAV_X", "NAV_Y", "NAV_SPEED", "NAV_HEADING"}) {
      Send(name, 1.0);
    }
  }
  void Send(const std::string& name, Value value) {
    app_->Deliver(std::make_shared<const Message>(Message{.name = name,
                                                          .value = std::move(value),
                                                          .time = link_.time,
                                                          .source = "test",
                                                          .source_aux = "",
                                                          .community = ""}));
  }
  /// `VARIABLE: text` of what one tick publishes.
  std::vector<std::string> Posts() {
    link_.published.clear();
    app_->Tick(link_.time);
    link_.time += Seconds(1.0);
    std::vector<std::string> posts;
    for (const auto& message : link_.published) {
      posts.push_back(message->name + ": " + std::get<std::string>(message->value));
    }
    return posts;
  }

 private:
  TestLink link_;
  AppContext context_;
  std::unique_ptr<App> app_;
};

TEST(StockNodeReporterBlock, EveryKeyOfMoosIvpIsRead) {
  EXPECT_THAT(
      ComplaintsAbout("AppTick = 2\nCommsTick = 2\nMaxAppTick = 8\nAPP_LOGGING = true\n"
                      "platform_type = kayak\nvessel_type = SHIP\nplatform_length = 4\n"
                      "vessel_length = 3.5\nplatform_beam = 1.2\nplatform_color = dodger_blue\n"
                      "platform_transparency = 0.5\nplatform_aspect = ID=439\ngroup = tango\n"
                      "platform_group = alpha\nplatform_vsource = ais\nvsource = ais\n"
                      "coord_policy_global = true\nallow_color_change = true\n"
                      "rider = var=DB_UPTIME, policy=always, rfld=upt, prec=3\n"
                      "terse_reports = true\nblackout_interval = 0\nblackout_variance = 2\n"
                      "plat_report_input = GPS_SAT, gap=5\nplat_report_var = A\n"
                      "platform_variable = B\nplat_report_output = PLATFORM_REPORT_LOCAL\n"
                      "node_report_output = NODE_REPORT_LOCAL\nnode_report_var = N\n"
                      "node_report_summary = N\nPAUSED = false\nnohelm_threshold = 0.2\n"
                      "cross_fill_policy = global\ncrossfill_policy = fill-empty\n"
                      "alt_nav_prefix = NAV_GT_\nalt_nav_name = _GT\nalt_nav_group = blue\n"
                      "nav_grace_period = -1\nextrap_enabled = true\nextrap_pos_thresh = 1\n"
                      "extrap_hdg_thresh = 1\nextrap_max_gap = 5\njson_report = true\n"
                      "report_cog = true\nhdg_error = 2\n"),
      IsEmpty());
}

TEST(StockNodeReporterBlock, AMisspeltKeyIsNamedWithItsLine) {
  EXPECT_THAT(ComplaintsAbout("platfrom_type = kayak\n"),
              ElementsAre(HasSubstr("stock.moos:3: platfrom_type: unknown key")));
}

TEST(StockNodeReporterBlock, OlderNamesGroupAndAspectsReachTheReport) {
  StockReporter reporter(
      "vessel_type = SHIP\nvessel_length = 8\nplatform_group = blue\nvsource = ais\n"
      "platform_transparency = 0.4\nplatform_aspect = ID=439\n");
  EXPECT_THAT(reporter.Posts(),
              ElementsAre(HasSubstr("TYPE=SHIP,GROUP=blue,VSOURCE=ais,MODE=NOHELM-EVER,"
                                    "TIME=1767225600,TRANSPARENCY=0.4,LENGTH=8,ID=439")));
}

TEST(StockNodeReporterBlock, RidersRideWhenTheirPolicySaysSo) {
  StockReporter reporter(
      "rider = var=DB_UPTIME, rfld=upt, prec=1\nrider = var=STATION, policy=updated\n");
  EXPECT_THAT(reporter.Posts()[0], testing::Not(HasSubstr("upt")));
  reporter.Send("DB_UPTIME", 12.34);
  reporter.Send("STATION", std::string("a,b"));
  EXPECT_THAT(reporter.Posts()[0], HasSubstr(",upt=12.3,STATION={a,b}"));
  EXPECT_THAT(reporter.Posts()[0], testing::EndsWith(",upt=12.3"));
}

TEST(StockNodeReporterBlock, ASecondPositionIsReportedUnderItsOwnNameWhileItIsFresh) {
  StockReporter reporter("alt_nav_prefix = NAV_GT\nalt_nav_group = red\n");
  reporter.Send("NAV_GT_X", 5.5);
  reporter.Send("NAV_GT_Y", 7.0);
  const std::vector<std::string> posts = reporter.Posts();
  ASSERT_EQ(posts.size(), 2U);
  EXPECT_THAT(posts[1], HasSubstr("NODE_REPORT_LOCAL: NAME=alpha_GT,X=5.5,Y=7,"));
  EXPECT_THAT(posts[1], HasSubstr(",GROUP=red,"));
  for (int second = 0; second < 6; ++second) {
    static_cast<void>(reporter.Posts());
  }
  EXPECT_EQ(reporter.Posts().size(), 1U);
}

TEST(StockNodeReporterBlock, JsonGoesWhereItIsAskedFor) {
  StockReporter both("json_report = NODE_JSON\n");
  EXPECT_THAT(both.Posts(), ElementsAre(HasSubstr("NODE_JSON: {\"NAME\":\"alpha\",\"X\":\"1\","),
                                        HasSubstr("NODE_REPORT_LOCAL: NAME=alpha,X=1,")));
  StockReporter alone("json_report = true\n");
  EXPECT_THAT(alone.Posts(), ElementsAre(HasSubstr("NODE_REPORT_LOCAL: {\"NAME\":\"alpha\",")));
}

TEST(StockNodeReporterBlock, APausedReporterIsSilentUntilToldOtherwise) {
  StockReporter reporter("paused = true\n");
  EXPECT_THAT(reporter.Posts(), IsEmpty());
  reporter.Send("PNR_PAUSE", std::string("false"));
  EXPECT_EQ(reporter.Posts().size(), 1U);
}

TEST(StockNodeReporterBlock, TheColorChangesOnlyWhereThatIsAllowed) {
  StockReporter fixed("platform_color = red\n");
  fixed.Send("NODE_COLOR_CHANGE", std::string("green"));
  EXPECT_THAT(fixed.Posts()[0], HasSubstr("COLOR=red"));
  StockReporter free("platform_color = red\nallow_color_change = true\n");
  free.Send("NODE_COLOR_CHANGE", std::string("green"));
  EXPECT_THAT(free.Posts()[0], HasSubstr("COLOR=green"));
}

TEST(StockNodeReporterBlock, KeysWithoutEffectAreNamedUnlessTheyAskForNothing) {
  UnusedReporterKeys keys;
  keys.cross_fill_policy = "literal";
  keys.blackout_variance = "0";
  keys.extrap_enabled = "false";
  keys.report_cog = "true";
  EXPECT_THAT(keys.Set(), ElementsAre("report_cog = true"));
}

TEST(StockNodeReporterBlock, ARiderThatIsNoneIsRefused) {
  EXPECT_THROW(StockReporter("rider = policy=always\n"), ConfigError);
  EXPECT_THROW(StockReporter("rider = var=A, policy=sometimes\n"), ConfigError);
  EXPECT_THROW(StockReporter("platform_aspect = big\n"), ConfigError);
}

}  // namespace
}  // namespace limpet
