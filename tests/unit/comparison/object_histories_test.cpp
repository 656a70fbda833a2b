// SPDX-License-Identifier: MIT
#include "limpet/comparison/object_histories.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace limpet {
namespace {

ObjectHistory HistoryOf(std::size_t since, const std::vector<HistoryEntry>& entries) {
  return {.color = "yellow",
          .p_W = {1.0, 2.0, 3.0},
          .placed_in = since,
          .since = since,
          .entries = entries};
}

HistoryEntry Decided(Status status, bool is_back = false) {
  return {.decided = status, .is_back = is_back, .posterior = std::nullopt, .id = 4};
}

TEST(StoryOf, AnObjectSeenOnceIsThatItWasSeen) {
  EXPECT_EQ(StoryOf(HistoryOf(0, {Decided(Status::kNew)})), "seen in 1");
  EXPECT_EQ(StoryOf(HistoryOf(2, {Decided(Status::kNew)})), "seen in 3");
}

TEST(StoryOf, AnObjectThatCameBackSaysSo) {
  EXPECT_EQ(StoryOf(HistoryOf(0, {Decided(Status::kNew), Decided(Status::kRemoved),
                                  Decided(Status::kConfirmed, true)})),
            "seen in 1, removed in 2, back in 3");
}

TEST(StoryOf, BackIsSaidOnlyOfWhatIsSurelyThere) {
  EXPECT_EQ(StoryOf(HistoryOf(0, {Decided(Status::kNew), Decided(Status::kRemoved),
                                  Decided(Status::kUncertain, true)})),
            "seen in 1, removed in 2, uncertain in 3");
}

TEST(StoryOf, SessionsCountFromTheFirstOfAllNotFromTheObjects) {
  EXPECT_EQ(StoryOf(HistoryOf(1, {Decided(Status::kNew), Decided(Status::kConfirmed),
                                  Decided(Status::kMoved), Decided(Status::kNotInspected)})),
            "seen in 2, confirmed in 3, moved in 4, " + std::string(NameOf(Status::kNotInspected)) +
                " in 5");
}

TEST(JsonOfASeries, HoldsEverySessionStepAndHistory) {
  SessionSeries series;
  for (int i = 0; i < 3; ++i) {
    SessionFacts facts;
    facts.session = "s" + std::to_string(i + 1);
    series.sessions.push_back(facts);
  }
  SessionComparison step;
  step.offset.shift_W = {0.5, -0.25};
  step.offset.turn = 0.1;
  OpiBelief object;
  object.landmark = 7;
  object.object.color = "orange";
  object.decided = Status::kNew;
  object.posterior = {.confirmed = 0.0, .removed = 0.0, .appeared = 0.9, .nothing = 0.1};
  step.objects = {object};
  series.steps = {step, step};
  HistoryEntry known = Decided(Status::kConfirmed);
  known.posterior = object.posterior;
  HistoryEntry gone = Decided(Status::kRemoved);
  gone.id.reset();
  series.objects = {HistoryOf(0, {Decided(Status::kNew), known, gone})};

  const nlohmann::json read = nlohmann::json::parse(Json(series));
  EXPECT_EQ(read["sessions"].size(), 3U);
  EXPECT_EQ(read["steps"].size(), 2U);
  EXPECT_EQ(read["changes"][0]["landmark_b"], 7);
  EXPECT_TRUE(read["changes"][0]["id_a"].is_null()) << "the former session had none";
  EXPECT_EQ(read["changes"][0]["posterior"]["new"], 0.9);
  EXPECT_EQ(read["offset"]["north_m"], 0.5);
  EXPECT_NEAR(read["offset"]["turn_deg"].get<double>(), 5.729578, 1e-5);
  const nlohmann::json& history = read["objects"][0];
  EXPECT_EQ(history["story"], "seen in 1, confirmed in 2, removed in 3");
  EXPECT_EQ(history["entries"][1]["session"], 2);
  EXPECT_EQ(history["entries"][1]["posterior"]["new"], 0.9);
  EXPECT_TRUE(history["entries"][0]["posterior"].is_null()) << "nothing to compare with yet";
  EXPECT_TRUE(history["entries"][2]["id"].is_null());
}

}  // namespace
}  // namespace limpet
