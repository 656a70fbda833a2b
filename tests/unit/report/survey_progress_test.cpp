// SPDX-License-Identifier: MIT
#include "limpet/report/survey_progress.hpp"

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using testing::HasSubstr;

/// What is written while a session goes through `phases`, each with a few reports of coverage.
std::string Told(const std::vector<std::string>& phases) {
  std::FILE* file = std::tmpfile();
  SessionRecord record("discovery");
  SurveyProgress progress("discovery", file);
  for (std::size_t i = 0; i < phases.size(); ++i) {
    record.phases.push_back({Seconds(static_cast<double>(i)), phases[i]});
    progress.Show(record);
    for (int report = 0; report < 3; ++report) {
      record.believed_coverage.push_back({Seconds(static_cast<double>(i)), Coverage{}});
      progress.Show(record);
    }
  }
  std::rewind(file);
  std::string text;
  for (int letter = std::fgetc(file); letter != EOF; letter = std::fgetc(file))
    text += static_cast<char>(letter);
  std::fclose(file);
  return text;
}

TEST(SurveyProgress, SaysAtOnceThatItWaitsForAFix) {
  EXPECT_EQ(Told({"ALIGN"}), "discovery   0 %  ALIGN   waiting at the surface for a good fix\n");
}

TEST(SurveyProgress, WritesOneLineForEachPhase) {
  const std::string text = Told({"ALIGN", "DIVE", "SURVEY", "RETURN"});
  EXPECT_EQ(std::ranges::count(text, '\n'), 4);
  EXPECT_THAT(text, HasSubstr("RETURN  on the way home"));
}

TEST(SurveyProgress, TellsOfWarningsRaisedAndOver) {
  std::FILE* file = std::tmpfile();
  SessionRecord record("discovery");
  record.begun = Seconds(100.0);
  SurveyProgress progress("discovery", file);
  record.warnings.push_back(
      {"pSurvey", "HELM_INACTIVE", Severity::kAlarm, "nothing is heard", Seconds(130.0), {}});
  progress.Show(record);
  progress.Show(record);  // once is enough
  record.warnings[0].to = Seconds(142.0);
  progress.Show(record);
  std::rewind(file);
  std::string text;
  for (int letter = std::fgetc(file); letter != EOF; letter = std::fgetc(file))
    text += static_cast<char>(letter);
  std::fclose(file);
  EXPECT_THAT(text, HasSubstr("30 s: pSurvey HELM_INACTIVE (alarm): nothing is heard\n"));
  EXPECT_THAT(text, HasSubstr("42 s: pSurvey HELM_INACTIVE (alarm) is over\n"));
  EXPECT_EQ(std::ranges::count(text, '\n'), 2);
}

TEST(SurveyProgress, GivesCoverageWhileItSurveys) {
  EXPECT_THAT(Told({"SURVEY"}), HasSubstr("SURVEY  seabed   0 %"));
}

}  // namespace
}  // namespace limpet
