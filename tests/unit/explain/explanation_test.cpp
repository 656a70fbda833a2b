// SPDX-License-Identifier: MIT
#include "limpet/explain/explanation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "limpet/explain/explanation_json.hpp"
#include "limpet/explain/explanation_text.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

BiddenOption Option(const std::string& source, std::vector<WeightedBid> bids) {
  BiddenOption option;
  option.source = source;
  option.length = 10.0;
  option.bids = std::move(bids);
  return option;
}

/// A beam that wins, gaps that would with a little more for looks, and a way out of the region.
LoggedDecision SurveyDecision() {
  HelmBids bids;
  bids.path_id = 4;
  bids.cause = "objects changed";
  const auto cover = [](double value) {
    return WeightedBid{
        "cover", 1.0, {.value = value, .why = {{"useful", value + 10.0}, {"length", 10.0}}}};
  };
  const auto revisit = [](double value) {
    return WeightedBid{"revisit", 0.5, {.value = value, .why = {{"looks_worth", value}}}};
  };
  const WeightedBid region{"region", 1.0, {.veto = "leaves the operating region"}};
  bids.options = {Option("beam", {cover(8.0), revisit(1.0)}),
                  Option("gaps", {cover(5.0), revisit(3.0)}), Option("tour", {cover(9.0), region})};
  return {.time = 545.25, .bids = Reweighted(bids, "", 0.0)};
}

TEST(Explanation, SaysWhyEachOptionLost) {
  const Explanation explanation = Explain(SurveyDecision());
  ASSERT_EQ(explanation.chosen, 0U);
  EXPECT_EQ(explanation.options[0].lost_because, "");
  EXPECT_EQ(explanation.options[1].lost_because, "0.2 less per metre, most by cover");
  EXPECT_EQ(explanation.options[2].lost_because, "vetoed by region: leaves the operating region");
}

TEST(Explanation, SaysThatOfEqualsTheFirstOfferWon) {
  LoggedDecision decision = SurveyDecision();
  decision.bids.options[1] = decision.bids.options[0];
  EXPECT_EQ(Explain(decision).options[1].lost_because, "worth the same, and offered later");
}

TEST(Explanation, HasTheReasonsOfEachBid) {
  const Bid bid = Explain(SurveyDecision()).options[0].bidden.bids[0].bid;
  ASSERT_EQ(bid.why.size(), 2U);
  EXPECT_EQ(bid.why[0].name, "useful");
  EXPECT_EQ(bid.why[0].value, 18.0);
}

TEST(Explanation, AsJsonIsAllThatOneNeedsToDecideAgain) {
  const auto json = nlohmann::json::parse(JsonOf(Explain(SurveyDecision()), "discovery"));
  EXPECT_EQ(json.at("session"), "discovery");
  EXPECT_EQ(json.at("t"), 545.25);
  EXPECT_EQ(json.at("cause"), "objects changed");
  EXPECT_EQ(json.at("chosen"), 0);
  for (const auto& option : json.at("options")) {
    double total = 0.0;
    for (const auto& bid : option.at("bids")) {
      total += bid.at("weight").get<double>() * bid.at("value").get<double>();
    }
    EXPECT_EQ(option.at("total"), total);
    EXPECT_EQ(option.at("rate"), total / option.at("rate_length_m").get<double>());
    EXPECT_EQ(option.at("rate_length_m"), option.at("length_m"));
  }
  EXPECT_EQ(json.at("options").at(2).at("vetoed_by"), "region");
  EXPECT_TRUE(json.at("options").at(0).at("vetoed_by").is_null());
  EXPECT_EQ(json.at("options").at(2).at("bids").at(1).at("veto"), "leaves the operating region");
  EXPECT_TRUE(json.at("options").at(0).at("bids").at(0).at("veto").is_null());
  EXPECT_EQ(json.at("options").at(0).at("bids").at(0).at("why").at("useful"), 18.0);
  const auto& flips = json.at("flips");
  ASSERT_EQ(flips.size(), 2U);
  EXPECT_EQ(flips.at(1).at("behavior"), "revisit");
  EXPECT_NEAR(flips.at(1).at("weight"), 1.5, 1e-6);
  EXPECT_EQ(flips.at(1).at("to"), 1);
}

TEST(Explanation, AsJsonSaysOverWhichLengthATotalIsRanked) {
  LoggedDecision decision = SurveyDecision();
  for (BiddenOption& option : decision.bids.options) {
    option.rate_length = 5.0;
    option.rate = option.total / 5.0;
  }
  const auto json = nlohmann::json::parse(JsonOf(Explain(decision), ""));
  for (const auto& option : json.at("options")) {
    EXPECT_EQ(option.at("rate_length_m"), 5.0);
    EXPECT_EQ(option.at("rate"), option.at("total").get<double>() / 5.0);
  }
}

TEST(Explanation, AsTextShowsTheTableAndWhatWouldHaveChangedIt) {
  const std::string text = PlainText(FrameOf(Explain(SurveyDecision())));
  EXPECT_THAT(text, HasSubstr("545.2 s: path 4, decided because: objects changed"));
  EXPECT_THAT(text, HasSubstr("->   0 beam"));
  EXPECT_THAT(text, HasSubstr("cover x 1"));
  EXPECT_THAT(text, HasSubstr("revisit x 0.5"));
  EXPECT_THAT(text, HasSubstr("pwt 1.501 or more"));
  EXPECT_THAT(text, HasSubstr("(is 0.5): then 1 gaps"));
  EXPECT_THAT(text, HasSubstr("useful 18, length 10"));
}

TEST(Explanation, SaysHowTheVehicleMoved) {
  const LoggedMotion moved{
      .time = 545.0,
      .motion = {.course_deg = 92.5,
                 .speed_mps = 0.5,
                 .depth_m = {},
                 .opinions = {{"follow", "course", 100.0, 0.97, 93.0, 0.0, 90.0},
                              {"avoid", "course+speed", 50.0, 0.4, {}, {}, {}}}},
      .stopped = {}};
  const Explanation explanation = Explain(SurveyDecision(), moved);
  const auto json = nlohmann::json::parse(JsonOf(explanation, "")).at("motion");
  EXPECT_EQ(json.at("course_deg"), 92.5);
  EXPECT_TRUE(json.at("depth_m").is_null());
  EXPECT_TRUE(json.at("stopped").is_null());
  EXPECT_EQ(json.at("bids").at(1).at("variables"), "course+speed");
  EXPECT_TRUE(json.at("bids").at(1).at("summit").is_null());
  const std::string text = PlainText(FrameOf(explanation));
  EXPECT_THAT(text,
              HasSubstr("moving now (545.0 s): course 92.5 deg, speed 0.5 m/s, depth nobody's"));
  EXPECT_THAT(text, HasSubstr("course 93 deg"));
  EXPECT_THAT(text, HasSubstr("0.97 x 100"));
  EXPECT_TRUE(nlohmann::json::parse(JsonOf(Explain(SurveyDecision()), "")).at("motion").is_null());
}

TEST(Explanation, NeedsNoOptionThatWon) {
  LoggedDecision decision = SurveyDecision();
  decision.bids.options.erase(decision.bids.options.begin(), decision.bids.options.begin() + 2);
  const Explanation explanation = Explain(decision);
  EXPECT_EQ(explanation.chosen, std::nullopt);
  EXPECT_TRUE(explanation.flips.empty());
  EXPECT_THAT(PlainText(FrameOf(explanation)), HasSubstr("every option is vetoed"));
  EXPECT_TRUE(nlohmann::json::parse(JsonOf(explanation, "")).at("chosen").is_null());
  decision.bids.options.clear();
  EXPECT_THAT(PlainText(FrameOf(Explain(decision))), HasSubstr("nobody offered anything"));
}

TEST(Explanation, ObeysNoNameFromSomebodysFile) {
  LoggedDecision decision = SurveyDecision();
  decision.bids.options[0].bids[0].behavior = "cover\x1b[2J\xff";
  decision.bids.options[0].source = "beam\n";
  const Explanation explanation = Explain(decision);
  EXPECT_THAT(PlainText(FrameOf(explanation)), Not(HasSubstr("\x1b")));
  EXPECT_TRUE(nlohmann::json::accept(JsonOf(explanation, "")));
}

TEST(Changes, AreALineADecision) {
  const std::vector<LoggedDecision> decisions{SurveyDecision()};
  const std::string text = PlainText(ChangesOf(decisions));
  EXPECT_THAT(text, HasSubstr("545.2     4  objects changed"));
  EXPECT_THAT(text, HasSubstr("beam, 10.0 m, 0.85 per metre, of 3 options"));
}

TEST(Explanation, SaysWhoDoesNotRunAndForWantOfWhat) {
  Explanation explanation = Explain(SurveyDecision());
  EXPECT_THAT(PlainText(FrameOf(explanation)), Not(HasSubstr("who does not run")));
  explanation.waiting = {
      {.name = "home", .what = "RETURN = true", .since = 3.5},
      {.name = "fix", .what = "completed-byduration", .since = 40.0, .is_done = true}};
  const std::string text = PlainText(FrameOf(explanation));
  EXPECT_THAT(text, HasSubstr("home"));
  EXPECT_THAT(text, HasSubstr("RETURN = true"));
  EXPECT_THAT(text, HasSubstr("nothing: completed-byduration"));
  const auto json = nlohmann::json::parse(JsonOf(explanation, ""));
  EXPECT_EQ(json.at("waiting").at(0).at("because"), "RETURN = true");
  EXPECT_EQ(json.at("waiting").at(1).at("state"), "completed");
}

}  // namespace
}  // namespace limpet
