// SPDX-License-Identifier: MIT
// The helm's own block, as MOOS-IvP's missions write it.
#include "limpet/helm/helm_params.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::HasSubstr;

ConfigBlock BlockWithGrace(const std::string& grace) {
  return {
      .name = "pHelm", .where = {"a.moos", 1}, .entries = {{"nav_grace", grace, {"a.moos", 4}}}};
}

struct GraceRead {
  Seconds grace{0.0};
  std::string complaint, note;
};

/// A block of nothing else, which lacks what else a survey needs.
GraceRead ReadGrace(const std::string& text) {
  HelmParams params;
  const ConfigBlock block = BlockWithGrace(text);
  const std::vector<ParamSpec> specs = DescribeParams(params);
  GraceRead read;
  for (const ConfigProblem& problem : ApplyBlock(block, specs)) {
    if (problem.key == "nav_grace") read.complaint += problem.Format();
  }
  for (const ConfigProblem& note : AlteredValues(block, specs))
    read.note += note.Format();
  read.grace = params.nav_grace;
  return read;
}

TEST(HelmParams, TakeANavGraceOfNothingForTheDefaultAndSaySo) {
  for (const char* text : {"0", "-1"}) {
    const GraceRead read = ReadGrace(text);
    EXPECT_EQ(read.grace, HelmParams{}.nav_grace) << text;
    EXPECT_EQ(read.complaint, "") << text;
    EXPECT_THAT(read.note, HasSubstr("a.moos:4: nav_grace: ")) << text;
    EXPECT_THAT(read.note, HasSubstr("is taken as 5")) << text;
  }
  EXPECT_EQ(ReadGrace("12").grace, Seconds(12.0));
  EXPECT_EQ(ReadGrace("12").note, "");
}

TEST(HelmParams, RefuseANavGraceBeyondTheirRange) {
  for (const char* text : {"0.01", "1e5", "soon"})
    EXPECT_THAT(ReadGrace(text).complaint, HasSubstr("is not allowed")) << text;
}

}  // namespace
}  // namespace limpet
