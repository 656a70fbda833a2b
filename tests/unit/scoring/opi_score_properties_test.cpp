// SPDX-License-Identifier: MIT
// Random fields and random reports of them: every object is found or missed, every report found or
// invented, each once, whatever order they come in.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/scoring/opi_score.hpp"

namespace limpet {
namespace {

constexpr double kReach = 2.5;  // [m] between an object and a report of it

class ScoredField : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  ScoredField() {
    for (int i = 0; i < 8; ++i) {
      ScenarioOpi opi{.name = "O" + std::to_string(i),
                      .color = random_.Chance(0.5) ? "yellow" : "green",
                      .radius_m = 0.5,
                      .places = {}};
      const Eigen::Vector3d place = Place();
      if (random_.Chance(0.8)) opi.places["discovery"] = place;
      if (random_.Chance(0.8)) opi.places["change"] = random_.Chance(0.8) ? place : Place();
      scenario_.opis.push_back(opi);
    }
    for (int i = 0; i < 7; ++i)
      record_.opis.push_back(Report(i));
  }
  Eigen::Vector3d Place() {
    return {random_.Uniform(-8.0, 8.0), random_.Uniform(-8.0, 8.0), random_.Uniform(5.0, 7.0)};
  }
  OpiBelief Report(int id) {
    const std::array<Status, 5> statuses{Status::kNew, Status::kConfirmed, Status::kRemoved,
                                         Status::kMoved, Status::kUncertain};
    OpiBelief belief;
    belief.id = id;
    belief.object.p_W = Place();
    belief.object.color = random_.Chance(0.5) ? "yellow" : "green";
    belief.decided = statuses[random_.Index(statuses.size())];
    belief.posterior = {0.4, 0.3, 0.2, 0.1};
    return belief;
  }
  [[nodiscard]] OpiScores Score() const { return ScoreOpis(record_, "discovery", scenario_, {}); }
  [[nodiscard]] static bool IsReport(const OpiBelief& belief) {
    return belief.decided == Status::kNew || belief.decided == Status::kConfirmed ||
           belief.decided == Status::kMoved;
  }

  Random random_{GetParam(), "opi_score"};
  Scenario scenario_;
  SessionRecord record_{"change"};
};

TEST_P(ScoredField, EveryObjectIsFoundOrMissedAndEveryReportFoundOrInvented) {
  const OpiScores scores = Score();
  std::multiset<std::string> named(scores.missed.begin(), scores.missed.end());
  for (const OpiScore& found : scores.found)
    named.insert(found.truth);
  std::multiset<std::string> there;
  for (const ScenarioOpi& opi : scenario_.opis) {
    if (opi.Place("change")) there.insert(opi.name);
  }
  EXPECT_EQ(named, there);
  EXPECT_EQ(scores.found.size() + scores.invented.size(),
            static_cast<std::size_t>(std::ranges::count_if(record_.opis, IsReport)));
}

TEST_P(ScoredField, AFoundObjectIsNearItsReportAndItsErrorIsTheirDistance) {
  for (const OpiScore& found : Score().found) {
    EXPECT_NEAR(found.error_m, (found.belief.object.p_W - found.truth_W).norm(), 1e-12);
    EXPECT_LE(found.error_m, kReach);
    EXPECT_NEAR(found.aligned_error_m, found.error_m, 1e-9) << "without an offset";
  }
}

TEST_P(ScoredField, NoObjectIsMissedBesideAnInventedReportOfIt) {
  const OpiScores scores = Score();
  for (const std::string& name : scores.missed) {
    const auto truth = std::ranges::find(scenario_.opis, name, &ScenarioOpi::name);
    for (const OpiBelief& invented : scores.invented) {
      EXPECT_GT((*truth->Place("change") - invented.object.p_W).norm(), kReach) << name;
    }
  }
}

TEST_P(ScoredField, TheOrderOfReportsAndObjectsDoesNotMatter) {
  const auto told = [](const OpiScores& scores) {
    std::set<std::string> lines;
    for (const OpiScore& found : scores.found) {
      lines.insert(found.truth + std::to_string(found.error_m));
    }
    for (const std::string& missed : scores.missed)
      lines.insert("missed " + missed);
    for (const ChangeScore& change : scores.changes) {
      lines.insert(fmt::format("{} {} {}", change.truth.value_or("?"),
                               change.expected ? NameOf(*change.expected) : "?",
                               NameOf(change.decided)));
    }
    return lines;
  };
  const auto before = told(Score());
  std::ranges::reverse(record_.opis);
  std::ranges::shuffle(scenario_.opis, random_.engine());
  EXPECT_EQ(told(Score()), before);
}

TEST_P(ScoredField, WhatIsExpectedFollowsFromWhereAnObjectWasAndIs) {
  std::size_t judged = 0;
  for (const ChangeScore& change : Score().changes) {
    if (!change.truth) {
      EXPECT_FALSE(change.expected || change.is_right());
      continue;
    }
    ++judged;
    const auto truth = std::ranges::find(scenario_.opis, *change.truth, &ScenarioOpi::name);
    const auto before = truth->Place("discovery"), now = truth->Place("change");
    const Status expected =
        before && now
            ? ((*before - *now).norm() >= 0.5 - 1e-6 ? Status::kMoved : Status::kConfirmed)
            : (before ? Status::kRemoved : Status::kNew);
    EXPECT_EQ(change.expected, expected) << *change.truth;
    EXPECT_EQ(change.is_right(), change.decided == expected);
    EXPECT_TRUE(change.p_W || change.is_open()) << "a status is of something";
  }
  EXPECT_EQ(judged, static_cast<std::size_t>(
                        std::ranges::count_if(scenario_.opis, [](const ScenarioOpi& opi) {
                          return opi.Place("discovery") || opi.Place("change");
                        })));
}

TEST_P(ScoredField, AMapOfTheTruthIsRightAboutEverything) {
  record_.opis.clear();
  std::vector<Eigen::Vector3d> taken;
  std::erase_if(scenario_.opis, [&taken](const ScenarioOpi& opi) {
    const auto place = opi.Place("change") ? opi.Place("change") : opi.Place("discovery");
    const bool is_near = place && std::ranges::any_of(taken, [&](const Eigen::Vector3d& other) {
                           return (*place - other).norm() < 6.0;
                         });
    if (place && !is_near) taken.push_back(*place);
    return !place || is_near ||
           (opi.Place("change") && opi.Place("discovery") &&
            (*opi.Place("change") - *opi.Place("discovery")).norm() >= 0.5 - 1e-6);
  });
  for (const ScenarioOpi& opi : scenario_.opis) {
    const auto before = opi.Place("discovery"), now = opi.Place("change");
    OpiBelief belief;
    belief.object.p_W = now ? *now : *before;
    belief.object.color = opi.color;
    belief.decided = !now ? Status::kRemoved : before ? Status::kConfirmed : Status::kNew;
    record_.opis.push_back(belief);
  }
  const OpiScores scores = Score();
  EXPECT_TRUE(scores.missed.empty() && scores.invented.empty());
  EXPECT_TRUE(std::ranges::all_of(scores.changes, &ChangeScore::is_right));
  EXPECT_EQ(scores.changes.size(), scenario_.opis.size());
}

INSTANTIATE_TEST_SUITE_P(RandomFields, ScoredField,
                         ::testing::Range(std::uint64_t{1}, std::uint64_t{17}));

}  // namespace
}  // namespace limpet
