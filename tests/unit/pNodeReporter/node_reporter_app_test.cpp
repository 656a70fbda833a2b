// SPDX-License-Identifier: MIT
#include "apps/pNodeReporter/node_reporter_app.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;

class NodeReporterTest : public ::testing::Test {
 protected:
  AppContext Context() {
    AppContext context;
    context.name = "pNodeReporter";
    context.link = &link_;
    context.globals = {
        {"Community", "alpha", {}}, {"LatOrigin", "43.721", {}}, {"LongOrigin", "10.283", {}}};
    return context;
  }
  void SendNavigation(App& app) const {
    link_.Send(app, topics::kNavX, 12.345);
    link_.Send(app, topics::kNavY, -3.0);
    link_.Send(app, topics::kNavSpeed, 0.5);
    link_.Send(app, topics::kNavHeading, 92.1);
    link_.Send(app, topics::kNavDepth, 3.5);
  }
  void SendHelm(App& app) const {
    link_.Send(app, topics::kHelmState, std::string("DRIVE"));
    link_.Send(app, topics::kHelmAllStop, std::string("clear"));
    link_.Send(app, topics::kHelmSummary,
               std::string("iter=3,utc_time=1.00,modes=MODE@ACTIVE:SURVEYING,idle_bhvs=none"));
  }
  std::optional<NodeReport> ReportOf(App& app) {
    app.Tick(link_.time);
    return link_.Last(topics::kNodeReportLocal);
  }
  TestLink link_;
};

TEST_F(NodeReporterTest, IsSilentUntilThePositionIsKnown) {
  NodeReporterApp app(Context(), {});
  SendHelm(app);
  EXPECT_FALSE(ReportOf(app));
  SendNavigation(app);
  EXPECT_TRUE(ReportOf(app));
}

TEST_F(NodeReporterTest, SaysWhereTheVehicleIsAndWhatItDoes) {
  NodeReporterApp app(Context(), {});
  SendNavigation(app);
  SendHelm(app);
  const auto report = ReportOf(app);
  ASSERT_TRUE(report);
  EXPECT_EQ(std::get<std::string>(link_.published.back()->value),
            "NAME=alpha,X=12.35,Y=-3,SPD=0.5,HDG=92.1,DEP=3.5,LAT=43.720973,LON=10.2831532,"
            "TYPE=uuv,MODE=MODE@ACTIVE:SURVEYING,ALLSTOP=clear,TIME=1767225600");
}

TEST_F(NodeReporterTest, AParkedHelmIsReportedAsParked) {
  NodeReporterApp app(Context(), {});
  SendNavigation(app);
  SendHelm(app);
  link_.Send(app, topics::kHelmState, std::string("PARK"));
  EXPECT_EQ(ReportOf(app)->mode, "PARK");
}

TEST_F(NodeReporterTest, ASilentHelmIsReportedWithTheSecondsOfItsSilence) {
  NodeReporterApp app(Context(), {});
  SendNavigation(app);
  EXPECT_EQ(ReportOf(app)->mode, "NOHELM-EVER");
  SendHelm(app);
  link_.time += Seconds(12.0);
  EXPECT_EQ(ReportOf(app)->mode, "NOHELM-12");
}

TEST_F(NodeReporterTest, AsksForTheModesItHasMissed) {
  NodeReporterApp app(Context(), {});
  link_.Send(app, topics::kHelmSummary, std::string("iter=900,utc_time=1.00"));
  link_.Send(app, topics::kHelmSummary, std::string("iter=901,utc_time=1.10"));
  ASSERT_EQ(link_.published.size(), 1U);
  EXPECT_EQ(link_.published[0]->name, "IVPHELM_REJOURNAL");
  EXPECT_EQ(link_.published[0]->value, Value(1.0)) << "the type that uHelmScope writes";
}

TEST_F(NodeReporterTest, KeepsToItsBlackoutInterval) {
  NodeReporterApp app(Context(), {.blackout_interval = Seconds(5.0)});
  SendNavigation(app);
  for (int i = 0; i < 10; ++i, link_.time += Seconds(1.0)) {
    app.Tick(link_.time);
  }
  EXPECT_EQ(link_.published.size(), 2U);
}

TEST_F(NodeReporterTest, TerseReportsLeaveOutWhatViewersCanDoWithout) {
  NodeReporterApp app(Context(), {.terse_reports = true});
  SendNavigation(app);
  const auto report = ReportOf(app);
  EXPECT_FALSE(report->depth);
  EXPECT_FALSE(report->latitude_deg);
}

TEST_F(NodeReporterTest, WithoutADatumReportsHaveNoLatitude) {
  AppContext context = Context();
  context.globals = {{"Community", "alpha", {}}};
  NodeReporterApp app(context, {});
  SendNavigation(app);
  EXPECT_FALSE(ReportOf(app)->latitude_deg);
}

TEST_F(NodeReporterTest, RefusesADatumThatIsNowhere) {
  AppContext context = Context();
  context.globals = {{"LatOrigin", "143.7", {}}, {"LongOrigin", "10", {}}};
  EXPECT_THROW(NodeReporterApp(context, {}), ConfigError);
}

TEST_F(NodeReporterTest, TellsTheOperatorWhatItReports) {
  NodeReporterApp app(Context(), {});
  SendNavigation(app);
  SendHelm(app);
  app.Tick(link_.time);
  ReportLines lines;
  app.Report(lines);
  EXPECT_THAT(lines.Text(), HasSubstr("x 12.35 m, y -3.00 m, depth 3.50 m"));
  EXPECT_THAT(lines.Text(), HasSubstr("MODE@ACTIVE:SURVEYING"));
}

}  // namespace
}  // namespace limpet
