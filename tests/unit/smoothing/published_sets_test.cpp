// SPDX-License-Identifier: MIT
// Published sets through the smoother: the batch minimum is reached.
#include "tests/support/published_sets.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/published_run.hpp"
#include "tests/unit/smoothing/set_file_fixture.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;

class PublishedSetTest : public ::testing::TestWithParam<const char*> {
 protected:
  static std::filesystem::path Folder() {
    return std::filesystem::path(LIMPET_SOURCE_DIR) / "../shared/data/gtsam_slam";
  }
};

TEST_P(PublishedSetTest, ReachesTheBatchMinimum) {
  const std::filesystem::path file = Folder() / GetParam();
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const Expected<PlanarGraph> graph = ReadPlanarGraph(file);
  ASSERT_TRUE(graph) << graph.error().text;
  const SetResult result = RunPlanarGraph(*graph, [] { return 0.0; });
  EXPECT_TRUE(result.finish.has_converged);
  EXPECT_LT(result.Excess(), 1e-6);
}
INSTANTIATE_TEST_SUITE_P(Planar, PublishedSetTest,
                         ::testing::Values("w100.graph", "example.graph"));

TEST_F(SetFileTest, BrokenLinesOfAGraphAreNamedByFileAndLine) {
  const std::string good = "VERTEX2 0 0 0 0\nVERTEX2 1 1 0 0\n";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"EDGE2 0 1 1 0 0 1 0 1 1 0\n", "g.graph:3: 11 words, not 12"},
      {"EDGE2 0 1 1 x 0 1 0 1 1 0 0\n", "g.graph:3: `x`"},
      {"EDGE2 0 1 1 nan 0 1 0 1 1 0 0\n", "g.graph:3: `nan`"},
      {"EDGE2 0 5 1 0 0 1 0 1 1 0 0\n", "g.graph:3: a pose that has no VERTEX2 line"},
      {"EDGE2 0 1 1 0 0 1 0.5 1 1 0 0\n", "g.graph:3: information that is not diagonal"},
      {"EDGE2 0 1 1 0 0 -1 0 1 1 0 0\n", "g.graph:3: `-1` is not positive"},
      {"EDGE2 1 1 1 0 0 1 0 1 1 0 0\n", "g.graph:3: an edge from a pose to itself"},
      {"BR 0 1.5 0 1 1 1\n", "g.graph:3: `1.5`"},
      {"VERTEX2 3 0 0 0\n", "g.graph:3: poses are not numbered"},
      {"EDGE3 0 1\n", "g.graph:3: `EDGE3`"},
      {"", "no edge between poses 0 and 1"}};
  for (const auto& [line, says] : cases) {
    const Expected<PlanarGraph> graph = ReadPlanarGraph(Write("g.graph", good + line));
    ASSERT_FALSE(graph) << line;
    EXPECT_THAT(graph.error().text, HasSubstr(says));
  }
  EXPECT_FALSE(ReadPlanarGraph(folder_.path() / "absent.graph"));
}

TEST_F(SetFileTest, BrokenLinesOfARangeSessionAreNamedByFileAndLine) {
  const std::filesystem::path stem = folder_.path() / "set";
  Write("set_TD.txt", "1.0 2 5 60.0\n1.5 2 5 -1\n");
  Write("set_DR.txt", "1.0 0.1 0.0\n0.5 0.1 0.0\n");
  EXPECT_THAT(ReadRangeSession(stem).error().text, HasSubstr("set_DR.txt:2: time goes back"));
  Write("set_DR.txt", "1.0 0.1 0.0\n");
  EXPECT_THAT(ReadRangeSession(stem).error().text, HasSubstr("set_TD.txt:2: `-1`"));
}

}  // namespace
}  // namespace limpet
