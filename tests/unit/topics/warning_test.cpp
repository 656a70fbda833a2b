// SPDX-License-Identifier: MIT
#include "limpet/topics/warning.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/topics/event.hpp"

namespace limpet {
namespace {

WarningFacts FactsOf(std::vector<std::string> raisers) {
  return {.severity = Severity::kAlarm,
          .raised_by = std::move(raisers),
          .meaning = "It leaks.",
          .action = "Pump.",
          .clears = "When it is dry."};
}

const WarningId kLeak = DeclareWarning("LEAK", FactsOf({"pHull"}));
const WarningFamily kHullRefuses = DeclareWarningFamily("REFUSES_<PART>", FactsOf({"pHull"}));
const WarningFamily kKeelRefuses = DeclareWarningFamily("REFUSES_<PORT>", FactsOf({"pKeel"}));
const EventId kStruck = DeclareEvent("STRUCK", {.reported_by = {"pHull"}, .meaning = "A blow."});

TEST(Warnings, CarryTheIdAndSeverityOfTheirDeclaration) {
  EXPECT_EQ(kLeak.name(), "LEAK");
  EXPECT_EQ(kLeak.severity(), Severity::kAlarm);
  EXPECT_EQ(kHullRefuses.Of("BOW").name(), "REFUSES_BOW");
  EXPECT_EQ(kHullRefuses.Of("BOW").severity(), Severity::kAlarm);
}

TEST(Warnings, AreFoundByWhatWasRaised) {
  ASSERT_NE(FindWarning("pHull", "LEAK"), nullptr);
  EXPECT_EQ(FindWarning("pHull", "LEAK")->facts.meaning, "It leaks.");
  EXPECT_EQ(FindWarning("pHull", "REFUSES_BOW")->id, "REFUSES_<PART>");
  EXPECT_EQ(FindWarning("pKeel", "REFUSES_9000")->id, "REFUSES_<PORT>");
  EXPECT_EQ(FindWarning("pHull_2", "LEAK")->id, "LEAK") << "an app may run under another name";
  EXPECT_EQ(FindWarning("pHull", "LEAKS"), nullptr);
}

using WarningsDeathTest = ::testing::Test;

TEST_F(WarningsDeathTest, NoneIsDeclaredTwice) {
  EXPECT_DEATH(static_cast<void>(DeclareWarning("LEAK", FactsOf({"pKeel"}))),
               "declared twice: LEAK");
  EXPECT_DEATH(static_cast<void>(DeclareWarningFamily("REFUSES_<X>", FactsOf({"pHull"}))),
               "declared twice");
  EXPECT_DEATH(static_cast<void>(DeclareEvent("STRUCK", {})), "declared twice: STRUCK");
}

TEST_F(WarningsDeathTest, NoneIsHiddenByAFamilyOfTheSameApp) {
  EXPECT_DEATH(static_cast<void>(DeclareWarning("REFUSES_ALL", FactsOf({"pHull"}))),
               "declared twice");
  EXPECT_DEATH(static_cast<void>(DeclareWarningFamily("RE<X>", FactsOf({}))), "declared twice");
}

TEST(Severities, HaveNamesThatAreRead) {
  for (const Severity severity : {Severity::kNote, Severity::kWarning, Severity::kAlarm}) {
    EXPECT_EQ(SeverityNamed(NameOf(severity)), severity);
  }
  EXPECT_FALSE(SeverityNamed("fatal"));
  EXPECT_GT(Severity::kAlarm, Severity::kNote);
}

}  // namespace
}  // namespace limpet
