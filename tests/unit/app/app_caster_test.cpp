// SPDX-License-Identifier: MIT
#include "limpet/app/app_caster.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/app/registry.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const Seconds kStart(1000.0);

WarningId Declared(const char* id, Severity severity) {
  return DeclareWarning(id, {.severity = severity,
                             .raised_by = {"pWatched"},
                             .meaning = "It happens.",
                             .action = "Look.",
                             .clears = "When it is over."});
}
const WarningId kLate = Declared("LATE", Severity::kWarning);
const WarningId kHot = Declared("HOT", Severity::kNote);
const WarningId kTorn = Declared("TORN", Severity::kAlarm);
const EventId kHappened =
    DeclareEvent("HAPPENED", {.reported_by = {"pWatched"}, .meaning = "It happened."});

class AppCasterTest : public ::testing::Test {
 protected:
  AppCasterTest() { caster_.Configure({.process = "pNav", .node = "alpha"}); }
  /// Whether a report goes out; sends it.
  bool Sends(double t) {
    if (!caster_.IsDue(kStart + Seconds(t))) return false;
    static_cast<void>(caster_.Cast({}, 1, kStart + Seconds(t)));
    return true;
  }
  void Ask(double t, const std::string& thresh = "any", const std::string& key = "uMAC") {
    caster_.OnRequest("node=alpha,app=pNav,duration=3,key=" + key + ",thresh=" + thresh,
                      kStart + Seconds(t));
  }
  AppCaster caster_;
};

TEST_F(AppCasterTest, ReportsOnceAtTheStartUnasked) {
  EXPECT_TRUE(Sends(0.0));
  EXPECT_FALSE(Sends(0.1));
  EXPECT_FALSE(Sends(100.0));
}

TEST_F(AppCasterTest, ReportsWhileARequestLivesAtTheIntervalAndNoLonger) {
  EXPECT_TRUE(Sends(0.0));
  Ask(1.0);
  EXPECT_TRUE(Sends(1.0));
  EXPECT_FALSE(Sends(1.4));
  EXPECT_TRUE(Sends(1.5));
  EXPECT_TRUE(Sends(3.9));
  EXPECT_FALSE(Sends(4.5));
}

TEST_F(AppCasterTest, IntervalAndDurationAreRealTimeUnderWarp) {
  caster_.Configure({.process = "pNav", .node = "alpha", .warp = 10.0});
  EXPECT_TRUE(Sends(0.0));
  Ask(1.0);
  EXPECT_FALSE(Sends(4.9));
  EXPECT_TRUE(Sends(5.0));
  EXPECT_FALSE(Sends(9.9));
  EXPECT_TRUE(Sends(30.0));
  EXPECT_FALSE(Sends(31.1));
}

TEST_F(AppCasterTest, RequestsOfOthersAreNoBusinessOfIts) {
  EXPECT_TRUE(Sends(0.0));
  caster_.OnRequest("node=bravo,app=pNav,duration=3,key=a", kStart);
  caster_.OnRequest("node=alpha,app=pMap,duration=3,key=a", kStart);
  caster_.OnRequest("!!", kStart);
  EXPECT_FALSE(Sends(1.0));
  caster_.OnRequest("node=all,app=all,duration=3,key=a", kStart + Seconds(1.0));
  EXPECT_TRUE(Sends(1.0));
}

TEST_F(AppCasterTest, WhoAsksForWarningsHearsWhenTheyChange) {
  EXPECT_TRUE(Sends(0.0));
  Ask(1.0, "run_warning");
  EXPECT_FALSE(Sends(1.0));
  caster_.RaiseWarning(kLate, "no DVL", Seconds(0.5));
  EXPECT_TRUE(Sends(1.5));
  EXPECT_FALSE(Sends(2.5));
  caster_.ClearWarning(kLate);
  EXPECT_TRUE(Sends(3.5));
}

TEST_F(AppCasterTest, WhoAsksLaterLearnsOfAWarningThatStands) {
  caster_.RaiseWarning(kLate, "no DVL", Seconds(0.5));
  EXPECT_TRUE(Sends(0.0));
  Ask(1.0, "run_warning");
  EXPECT_TRUE(Sends(1.0));
  Ask(2.0, "run_warning");
  EXPECT_FALSE(Sends(2.0));
}

TEST_F(AppCasterTest, ANewConfigurationWarningNeedsNobodyToAsk) {
  EXPECT_TRUE(Sends(0.0));
  caster_.AddConfigWarning("no datum");
  EXPECT_TRUE(Sends(0.1));
  EXPECT_FALSE(Sends(0.2));
}

TEST_F(AppCasterTest, CountsHowOftenAWarningWasRaisedAndDropsItWhenCleared) {
  for (const double t : {1.0, 2.0}) {
    caster_.RaiseWarning(kHot, "first", Seconds(t));
    caster_.ClearWarning(kHot);
  }
  caster_.RaiseWarning(kHot, "first", Seconds(3.0));
  caster_.RaiseWarning(kHot, "second", Seconds(9.0));  // it stands: only its text follows
  caster_.RaiseWarning(kLate, "third", Seconds(4.25));
  EXPECT_THAT(caster_.Cast({}, 1, kStart).run_warnings,
              ElementsAre(CountedWarning{"LATE (warning since [4.25]): third", 1},
                          CountedWarning{"HOT (note since [3.00]): second", 3}));
  EXPECT_EQ(caster_.Cast({}, 1, kStart).run_warning_total, 4);
  caster_.ClearWarning(kHot);
  EXPECT_EQ(caster_.Cast({}, 1, kStart).run_warning_total, 1);
}

TEST_F(AppCasterTest, NoAlarmIsLeftOutForWantOfRoom) {
  caster_.Configure({.process = "pNav", .node = "", .max_run_warnings = 2});
  for (const WarningId& id : {kHot, kLate, kTorn}) {
    caster_.RaiseWarning(id, "it is so", Seconds(1.0));
  }
  EXPECT_THAT(caster_.Cast({}, 1, kStart).run_warnings,
              ElementsAre(CountedWarning{"TORN (alarm since [1.00]): it is so", 1},
                          CountedWarning{"LATE (warning since [1.00]): it is so", 1}));
}

TEST_F(AppCasterTest, KeepsTheLastFewEvents) {
  caster_.Configure({.process = "pNav", .node = "", .max_events = 2});
  for (const double t : {1.0, 2.5, 3.0}) {
    caster_.AddEvent(Seconds(t), "it happened");
  }
  EXPECT_THAT(caster_.Cast({}, 1, kStart).events,
              ElementsAre("[2.50]: it happened", "[3.00]: it happened"));
}

TEST_F(AppCasterTest, ManyStrangersCostNoMemory) {
  EXPECT_TRUE(Sends(0.0));
  for (int i = 0; i < 100'000; ++i) {
    Ask(0.0, "any", std::to_string(i));
  }
  EXPECT_TRUE(Sends(1.0));
  EXPECT_FALSE(Sends(3.1));
}

TEST(CastSettings, AreReadFromTheAppsBlock) {
  ConfigBlock block{.name = "pNav", .where = {}, .entries = {{"TERM_REPORT_INTERVAL", "2", {}}}};
  EXPECT_EQ(ReadCastSettings(block).interval, Seconds(2.0));
  block.entries = {{"MAX_APPCAST_EVENTS", "51", {"m.moos", 7}}};
  EXPECT_THROW(static_cast<void>(ReadCastSettings(block)), ConfigError);
}

class WatchedApp final : public App {
 public:
  explicit WatchedApp(const AppContext& context) : App(context) {}
  void Tick(Seconds) override { ReportEvent(kHappened, "ticked"); }
  void Report(ReportLines& report) const override { report.Pair("Depth", "3 m"); }
};

class ReportingTest : public ::testing::Test {
 protected:
  AppContext Context(bool runs_live) {
    AppContext context;
    context.name = "pWatched";
    context.link = &link_;
    context.globals = {{"Community", "alpha", {}}};
    context.runs_live = runs_live;
    return context;
  }
  std::vector<AppCast> Casts() const {
    std::vector<AppCast> casts;
    for (const MessagePtr& message : link_.published) {
      if (message->name == "APPCAST") {
        casts.push_back(*DecodeAppCast(std::get<std::string>(message->value)));
      }
    }
    return casts;
  }
  TestLink link_;
};

TEST_F(ReportingTest, ALiveAppTellsWhatItHasToTell) {
  WatchedApp app(Context(true));
  app.StartReporting({});
  link_.time += Seconds(1.25);
  app.Iterate(link_.time);
  ASSERT_EQ(Casts().size(), 1U);
  EXPECT_EQ(Casts()[0], (AppCast{.process = "pWatched",
                                 .node = "alpha",
                                 .iteration = 1,
                                 .messages = {"Depth:        3 m"},
                                 .config_warnings = {},
                                 .events = {"[1.25]: HAPPENED: ticked"},
                                 .run_warning_total = 0,
                                 .run_warnings = {}}));
}

TEST_F(ReportingTest, AnEmbeddedAppReportsAtTheEndAndWhenAsked) {
  WatchedApp app(Context(false));
  app.StartReporting({});
  app.Iterate(link_.time);
  EXPECT_TRUE(Casts().empty());
  app.Deliver(std::make_shared<const Message>(Message{.name = "APPCAST_REQ",
                                                      .value = std::string("key=a,duration=1"),
                                                      .time = link_.time,
                                                      .source = "",
                                                      .source_aux = "",
                                                      .community = ""}));
  app.Iterate(link_.time);
  EXPECT_EQ(Casts().size(), 1U);
  app.End(link_.time);
  EXPECT_EQ(Casts().size(), 2U);
  EXPECT_EQ(Casts().back().iteration, 2);
}

TEST_F(ReportingTest, ALiveAppWithoutAVehicleNameDoubtsItsConfiguration) {
  AppContext context = Context(true);
  context.globals.clear();
  WatchedApp app(context);
  app.StartReporting({});
  app.Iterate(link_.time);
  EXPECT_THAT(Casts()[0].config_warnings, ElementsAre(HasSubstr("Community")));
}

}  // namespace
}  // namespace limpet
