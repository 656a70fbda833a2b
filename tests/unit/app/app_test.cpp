// SPDX-License-Identifier: MIT
#include "limpet/app/app.hpp"

#include <concepts>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/app/registry.hpp"
#include "limpet/topics/navigation.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const WarningId kLow = DeclareWarning("LOW", {.severity = Severity::kAlarm,
                                              .raised_by = {"pEcho"},
                                              .meaning = "It is low.",
                                              .action = "Lift it.",
                                              .clears = "When it is high."});
const EventId kEchoed = DeclareEvent("ECHOED", {.reported_by = {"pEcho"}, .meaning = "It echoed."});

/// What is no declaration cannot be raised or reported: it does not compile.
static_assert(!std::convertible_to<const char*, WarningId>);
static_assert(!std::constructible_from<WarningId, std::string, Severity>);
static_assert(!std::constructible_from<WarningFamily, std::string, Severity>);
static_assert(!std::constructible_from<EventId, std::string>);

/// Doubles every NAV_DEPTH it hears.
class EchoApp final : public App {
 public:
  struct Params {
    Meters offset{1.0};
    template <class V>
    void Describe(V& visit) {
      using namespace literals;
      visit("offset_m", offset, "Added to each depth", InRange(0.0_m, 10.0_m));
    }
  };
  EchoApp(const AppContext& context, const Params& params) : App(context), params_(params) {
    Subscribe(topics::kNavDepth, &EchoApp::OnDepth);
    Subscribe(topics::kNavDeadReckoning, &EchoApp::OnDeadReckoning);
    SubscribeRaw(WildcardFilter{.app_pattern = "*", .variable_pattern = "EXTRA_*", .interval = {}},
                 [this](const MessagePtr& message) { heard.push_back(message->name); });
  }
  double Draw(const char* part) const { return MakeRandom(part).Uniform(0.0, 1.0); }
  void Raise(const std::string& text) { Warn(kLow, text); }
  void Lower() { ClearWarning(kLow); }
  void Tell() { ReportEvent(kEchoed, "twice"); }

  std::vector<std::string> heard;

 private:
  void OnDepth(const Stamped<double>& depth) {
    Publish(topics::kNavX, depth.value + params_.offset.value());
  }
  void OnDeadReckoning(const Stamped<DeadReckoning>&) { heard.emplace_back("DR"); }
  Params params_;
};

LIMPET_REGISTER_APP(EchoApp, "pEcho", 5.0);

class AppTest : public ::testing::Test {
 protected:
  AppContext Context() {
    AppContext context;
    context.name = "pEcho";
    context.link = &link_;
    context.session = "discovery";
    context.seed = 1;
    return context;
  }
  void Send(App& app, const std::string& name, Value value) const {
    app.Deliver(std::make_shared<const Message>(Message{.name = name,
                                                        .value = std::move(value),
                                                        .time = link_.time,
                                                        .source = "pOther",
                                                        .source_aux = "",
                                                        .community = ""}));
  }
  TestLink link_;
};

TEST_F(AppTest, SubscribesToWhatItHandles) {
  const EchoApp app(Context(), {});
  EXPECT_THAT(link_.subscriptions, ElementsAre("NAV_DEPTH", "NAV_DEAD_RECKONING", "EXTRA_*"));
}

TEST_F(AppTest, AnswersMail) {
  EchoApp app(Context(), {});
  Send(app, "NAV_DEPTH", 3.0);
  EXPECT_EQ(link_.Last(topics::kNavX), 4.0);
}

TEST_F(AppTest, HearsWildcardMailUndecoded) {
  EchoApp app(Context(), {});
  Send(app, "EXTRA_A", Binary{});
  Send(app, "OTHER", 1.0);
  EXPECT_THAT(app.heard, ElementsAre("EXTRA_A"));
}

TEST_F(AppTest, WarnsOfMailThatDoesNotDecode) {
  EchoApp app(Context(), {});
  Send(app, "NAV_DEAD_RECKONING", std::string("north=abc"));
  EXPECT_TRUE(app.heard.empty());
  EXPECT_THAT(app.warnings().at("BAD_MAIL_NAV_DEAD_RECKONING").text, HasSubstr("pOther"));
  link_.Send(app, topics::kNavDeadReckoning, DeadReckoning{});
  EXPECT_TRUE(app.warnings().empty());
}

TEST_F(AppTest, PublishesAWarningOnceAndItsEnd) {
  EchoApp app(Context(), {});
  app.Raise("first");
  app.Raise("first");
  ASSERT_EQ(link_.published.size(), 1U);
  EXPECT_EQ(link_.published[0]->name, "PECHO_WARNINGS");
  EXPECT_EQ(link_.published[0]->value, Value(std::string("LOW (alarm): first")));
  app.Lower();
  EXPECT_EQ(link_.published.back()->value, Value(std::string("none")));
}

TEST_F(AppTest, AStandingWarningSaysWhatIsSoNowAndSinceWhenItStands) {
  EchoApp app(Context(), {});
  const Seconds raised = link_.time;
  app.Raise("1 lost");
  link_.time += Seconds(5.0);
  app.Raise("2 lost");
  EXPECT_EQ(app.warnings().at("LOW").text, "2 lost");
  EXPECT_EQ(app.warnings().at("LOW").since, raised);
}

TEST_F(AppTest, ATextThatChangesAtEveryTickIsToldNowAndThen) {
  EchoApp app(Context(), {});
  for (int tick = 0; tick < 40; ++tick) {
    app.Raise(std::to_string(tick));
    app.Iterate(link_.time);
    link_.time += Seconds(0.25);
  }
  std::vector<std::string> told;
  for (const MessagePtr& message : link_.published) {
    if (message->name == "PECHO_WARNINGS") told.push_back(std::get<std::string>(message->value));
  }
  EXPECT_THAT(told, ElementsAre("LOW (alarm): 0", "LOW (alarm): 8", "LOW (alarm): 16",
                                "LOW (alarm): 24", "LOW (alarm): 32"));
}

TEST_F(AppTest, TheReportHasSeverityAndTimesOfWarningsAndEvents) {
  EchoApp app(Context(), {});
  app.StartReporting({});
  link_.time += Seconds(2.0);
  app.Raise("first");
  link_.time += Seconds(1.0);
  app.Tell();
  app.End(link_.time);
  const AppCast cast = *DecodeAppCast(std::get<std::string>(link_.published.back()->value));
  EXPECT_EQ(cast.run_warnings.at(0).text, "LOW (alarm since [2.00]): first");
  EXPECT_THAT(cast.events, ElementsAre("[2.00]: alarm LOW: first", "[3.00]: ECHOED: twice"));
}

TEST_F(AppTest, WarnsWhileTheDatabasesClockRunsAway) {
  EchoApp app(Context(), {});
  link_.clock_disagreement = Seconds(-3.0);
  app.Iterate(link_.time);
  EXPECT_THAT(app.warnings().at("CLOCK_DIFFERS").text, HasSubstr("-3.0 s off"));
  link_.clock_disagreement = Seconds(0.4);
  app.Iterate(link_.time);
  EXPECT_FALSE(app.warnings().contains("CLOCK_DIFFERS"));
}

TEST_F(AppTest, DrawsTheSameNumbersForTheSameSeedNameSessionAndPart) {
  const EchoApp app(Context(), {});
  EXPECT_EQ(app.Draw("noise"), app.Draw("noise"));
  EXPECT_NE(app.Draw("noise"), app.Draw("bias"));
  AppContext other = Context();
  other.session = "change";
  EXPECT_NE(app.Draw("noise"), EchoApp(other, {}).Draw("noise"));
  other = Context();
  other.seed = 2;
  EXPECT_NE(app.Draw("noise"), EchoApp(other, {}).Draw("noise"));
}

TEST_F(AppTest, FindsGlobalsWithoutCase) {
  AppContext context = Context();
  context.globals = {{"LatOrigin", "43.7", {}}, {"latorigin", "1", {}}};
  EXPECT_EQ(context.Global("LATORIGIN"), "43.7");
  EXPECT_EQ(context.Global("None"), "");
}

TEST_F(AppTest, IsBuiltFromItsBlockByName) {
  const AppEntry& entry = AppRegistry().at("pEcho");
  EXPECT_EQ(entry.default_tick_hz, 5.0);
  EXPECT_EQ(entry.describe().at(0).name, "offset_m");
  const ConfigBlock block{
      .name = "pEcho", .where = {}, .entries = {{"AppTick", "4", {}}, {"offset_m", "2", {}}}};
  const std::unique_ptr<App> app = entry.create(Context(), block);
  Send(*app, "NAV_DEPTH", 3.0);
  EXPECT_EQ(link_.Last(topics::kNavX), 5.0);
}

TEST_F(AppTest, RefusesAnUnknownKeyWithItsPlace) {
  const ConfigBlock block{
      .name = "pEcho", .where = {}, .entries = {{"ofset_m", "2", {"m.moos", 12}}}};
  try {
    static_cast<void>(AppRegistry().at("pEcho").create(Context(), block));
    FAIL() << "must not build";
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "m.moos:12: ofset_m: unknown key in pEcho; did you mean `offset_m`?");
  }
}

TEST_F(AppTest, SaysThatASuccessorWouldKnowNothingOfThisLife) {
  EchoApp app(Context(), {});
  app.NoteJournalLost("No space left on device");
  EXPECT_THAT(app.warnings().at("JOURNAL_LOST").text,
              testing::HasSubstr("No space left on device"));
}

}  // namespace
}  // namespace limpet
