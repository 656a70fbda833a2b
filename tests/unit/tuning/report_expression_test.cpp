// SPDX-License-Identifier: MIT
#include "limpet/tuning/report_expression.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using testing::HasSubstr;

const char* const kReport = R"({"mission": "m", "seed": 3, "sessions": {"discovery": {
  "path_m": 400.5, "covered": 0.98, "ended": "home", "missed": ["OPI 2"], "good": true,
  "coverage": [{"level": 0.9, "path_m": 200.0}, {"level": 0.95, "path_m": null}],
  "opis": [{"error_m": 0.5}, {"error_m": 0.25}]}}})";

ReportValues Report() { return *ReportValues::FromJson(kReport); }

std::optional<double> Value(const std::string& text) {
  const auto expression = ReportExpression::Parse(text);
  EXPECT_TRUE(expression) << (expression ? "" : expression.error().text);
  return expression ? expression->Evaluate(Report()) : std::nullopt;
}

std::string ComplaintOf(const std::string& text) {
  const auto expression = ReportExpression::Parse(text);
  EXPECT_FALSE(expression) << text;
  return expression ? "" : expression.error().text;
}

TEST(ReportExpression, ReadsNumbersOfAReportByTheirKeys) {
  EXPECT_EQ(Value("sessions.discovery.path_m"), 400.5);
  EXPECT_EQ(Value("seed"), 3.0);
  EXPECT_EQ(Value("sessions.discovery.coverage.90.path_m"), 200.0);
  EXPECT_EQ(Value("sessions.discovery.opis.1.error_m"), 0.25);
  EXPECT_EQ(Value("sessions.discovery.missed.count"), 1.0);
  EXPECT_EQ(Value("sessions.discovery.good"), 1.0);
}

TEST(ReportExpression, BindsAsArithmeticDoes) {
  EXPECT_EQ(Value("1 + 2 * 3"), 7.0);
  EXPECT_EQ(Value("(1 + 2) * 3"), 9.0);
  EXPECT_EQ(Value("10 - 4 - 3"), 3.0);
  EXPECT_EQ(Value("16 / 4 / 2"), 2.0);
  EXPECT_EQ(Value("2 ^ 3 ^ 2"), 512.0);
  EXPECT_EQ(Value("-2 ^ 2"), -4.0);
  EXPECT_EQ(Value("2 ^ -1"), 0.5);
  EXPECT_EQ(Value("1 - -1"), 2.0);
  EXPECT_EQ(Value(" 1e2+.5 "), 100.5);
}

TEST(ReportExpression, KnowsMinMaxAbsAndSqrt) {
  EXPECT_EQ(Value("min(3, 1, 2) + max(3, 1) + abs(-4) + sqrt(9)"), 11.0);
}

TEST(ReportExpression, ComparesAndDecides) {
  EXPECT_EQ(Value("sessions.discovery.covered >= 0.95 and seed == 3"), 1.0);
  EXPECT_EQ(Value("not (1 < 2) or 2 != 2"), 0.0);
  EXPECT_EQ(Value("not 1 > 2"), 1.0);
  EXPECT_EQ(Value("1 <= 1 and not 0"), 1.0);
  EXPECT_TRUE(ReportExpression::Parse("1 < 2")->is_condition());
  EXPECT_TRUE(ReportExpression::Parse("not seed")->is_condition());
  EXPECT_FALSE(ReportExpression::Parse("1 + (1 < 2)")->is_condition());
}

TEST(ReportExpression, HasNoValueWhereALevelWasNeverReached) {
  EXPECT_EQ(Value("sessions.discovery.coverage.95.path_m + 1"), std::nullopt);
  EXPECT_EQ(Value("1 / 0"), std::nullopt);
  EXPECT_EQ(Value("sqrt(-1)"), std::nullopt);
}

TEST(ReportExpression, SaysWhereItCannotBeRead) {
  EXPECT_THAT(ComplaintOf("1 + "), HasSubstr("at 5: a number"));
  EXPECT_THAT(ComplaintOf("(1 + 2"), HasSubstr("at 7: `)` is expected"));
  EXPECT_THAT(ComplaintOf("1 2"), HasSubstr("at 3: an operator"));
  EXPECT_THAT(ComplaintOf("mean(1)"), HasSubstr("at 1: no function `mean`"));
  EXPECT_THAT(ComplaintOf("1 + abs(1, 2)"), HasSubstr("at 5: abs takes one argument"));
  EXPECT_THAT(ComplaintOf("1 < 2 < 3"), HasSubstr("do not chain"));
  EXPECT_THAT(ComplaintOf(""), HasSubstr("at 1: a number"));
  EXPECT_THAT(ComplaintOf("1.2.3"), HasSubstr("at 1"));
  EXPECT_THAT(ComplaintOf("2x"), HasSubstr("at 1"));
}

TEST(ReportExpression, RefusesWhatIsNestedTooDeepOrTooLong) {
  EXPECT_THAT(ComplaintOf(std::string(1000, '(')), HasSubstr("nested deeper than 64"));
  EXPECT_THAT(ComplaintOf(std::string(1000, '-') + "1"), HasSubstr("nested deeper"));
  EXPECT_THAT(ComplaintOf(std::string(5000, '1')), HasSubstr("at most 4096"));
  std::string chain = "1";
  for (int i = 0; i < 2000; ++i)
    chain += "+1";
  EXPECT_EQ(Value(chain), 2001.0);
}

TEST(ReportExpression, NamesTheNearestKeyForOneThatNoReportHas) {
  const auto expression = ReportExpression::Parse("2 * sessions.discovery.path");
  const auto complaint = expression->UnknownKey(Report());
  ASSERT_TRUE(complaint);
  EXPECT_THAT(*complaint, HasSubstr("at 5"));
  EXPECT_THAT(*complaint, HasSubstr("did you mean `sessions.discovery.path_m`?"));
  const auto null_key = ReportExpression::Parse("sessions.discovery.coverage.95.path_m");
  EXPECT_FALSE(null_key->UnknownKey(Report()));
}

TEST(ReportValues, RefusesWhatIsNoReport) {
  EXPECT_FALSE(ReportValues::FromJson("[1, 2]"));
  EXPECT_FALSE(ReportValues::FromJson("{"));
}

}  // namespace
}  // namespace limpet
