// SPDX-License-Identifier: MIT
#include "limpet/scoring/verdict.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::HasSubstr;

SessionScore HomeWith(int found) {
  SessionScore session;
  session.ended = "home";
  session.home_error_m = 1.0;
  for (int i = 0; i < found; ++i) {
    OpiScore opi;
    opi.truth = "buoy " + std::to_string(i);
    opi.error_m = 0.2;
    session.opis.found.push_back(opi);
  }
  return session;
}

ChangeScore Decision(Status expected, Status decided) {
  ChangeScore change;
  change.truth = "buoy";
  change.expected = expected;
  change.decided = decided;
  return change;
}

/// Two sessions without a fault.
RunScore FlawlessRun() {
  RunScore run;
  run.sessions = {HomeWith(4), HomeWith(4)};
  run.sessions[1].opis.changes = {Decision(Status::kConfirmed, Status::kConfirmed),
                                  Decision(Status::kRemoved, Status::kRemoved)};
  return run;
}

TEST(Verdict, OfARunWithoutFaultIsGood) {
  const Verdict verdict = VerdictOf(FlawlessRun());
  EXPECT_TRUE(verdict.is_good);
  EXPECT_EQ(verdict.text,
            "2 of 2 statuses right; objects: none missed, none invented, none misplaced");
}

/// What spoils a run, and the words that say so.
struct Fault {
  const char* name;
  void (*spoil)(RunScore& run);
  const char* said;
};

class FaultyRun : public ::testing::TestWithParam<Fault> {};

TEST_P(FaultyRun, IsNotGoodAndSaysWhy) {
  RunScore run = FlawlessRun();
  GetParam().spoil(run);
  const Verdict verdict = VerdictOf(run);
  EXPECT_FALSE(verdict.is_good);
  EXPECT_TRUE(verdict.is_judged);
  EXPECT_THAT(verdict.text, HasSubstr(GetParam().said));
}

INSTANTIATE_TEST_SUITE_P(
    Faults, FaultyRun,
    ::testing::Values(
        Fault{"AnObjectMissed", [](RunScore& run) { run.sessions[0].opis.missed = {"buoy 5"}; },
              "1 missed"},
        Fault{"AnObjectInvented",
              [](RunScore& run) { run.sessions[1].opis.invented.emplace_back(); }, "1 invented"},
        Fault{"AnObjectMisplaced",
              [](RunScore& run) { run.sessions[0].opis.found[2].error_m = kGoodError + 0.01; },
              "1 misplaced"},
        Fault{"AStatusWrong",
              [](RunScore& run) {
                run.sessions[1].opis.changes[0] = Decision(Status::kConfirmed, Status::kRemoved);
              },
              "1 of 2 statuses right"},
        Fault{"AStatusUncertain",
              [](RunScore& run) {
                run.sessions[1].opis.changes[1] = Decision(Status::kRemoved, Status::kUncertain);
              },
              "1 of 2 statuses right"},
        Fault{"ADecisionAboutNothing",
              [](RunScore& run) {
                ChangeScore change;
                change.decided = Status::kNew;
                run.sessions[1].opis.changes.push_back(change);
              },
              "2 of 3 statuses right"},
        Fault{"TheEndTooFarFromTheStart",
              [](RunScore& run) { run.sessions[0].home_error_m = kHomeRadius + 0.01; },
              "1 of 2 sessions not home"},
        Fault{"AnEndThatIsNotHome", [](RunScore& run) { run.sessions[1].ended = "timeout"; },
              "1 of 2 sessions not home"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Verdict, OfNoSessionIsNotGood) { EXPECT_FALSE(VerdictOf(RunScore{}).is_good); }

TEST(Verdict, JudgesNothingIfOneSessionHasNoTruth) {
  RunScore run = FlawlessRun();
  run.sessions[1].has_truth = false;
  run.sessions[1].opis = {};
  run.sessions[1].opis.reported.resize(3);
  const Verdict verdict = VerdictOf(run);
  EXPECT_FALSE(verdict.is_good);
  EXPECT_FALSE(verdict.is_judged);
  EXPECT_EQ(verdict.text, "no truth in 1 of 2 sessions: nothing is judged; 7 objects reported");
}

TEST(Verdict, IsNotHomeWhereTheTrueEndIsUnknown) {
  SessionScore session = HomeWith(0);
  session.home_error_m.reset();
  EXPECT_FALSE(IsHome(session));
}

}  // namespace
}  // namespace limpet
