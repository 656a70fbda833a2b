// SPDX-License-Identifier: MIT
// Published sets, and small ones like them, through the smoother: the batch minimum is reached.
#include "tests/support/published_sets.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "tests/support/beacon_start.hpp"
#include "tests/support/matlab_matrices.hpp"
#include "tests/support/published_run.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;

double NoClock() { return 0.0; }

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
  const SetResult result = RunPlanarGraph(*graph, NoClock);
  EXPECT_TRUE(result.finish.has_converged);
  EXPECT_LT(result.Excess(), 1e-6);
}
INSTANTIATE_TEST_SUITE_P(Planar, PublishedSetTest,
                         ::testing::Values("w100.graph", "example.graph"));

/// Rounds of a square with closures to every place that was there before, and landmarks.
PlanarGraph SquareGraph(int poses, double noise, double turn_noise) {
  Random random(3);
  PlanarGraph graph;
  std::vector<Eigen::Vector3d> truth;
  const std::vector<Eigen::Vector2d> landmarks{{2.0, 7.0}, {7.0, 3.0}};
  const auto seen_from = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const double c = std::cos(a.z()), s = std::sin(a.z());
    const Eigen::Vector3d d = b - a;
    return Eigen::Vector3d(c * d.x() + s * d.y(), -s * d.x() + c * d.y(), WrapAngle(d.z()));
  };
  const auto edge = [&](int from, int to) {
    PlanarEdge e{.from = from, .to = to};
    e.variance << noise * noise, noise * noise, turn_noise * turn_noise;
    e.motion =
        seen_from(truth[static_cast<std::size_t>(from)], truth[static_cast<std::size_t>(to)]);
    e.motion +=
        Eigen::Vector3d(random.Normal(noise), random.Normal(noise), random.Normal(turn_noise));
    return e;
  };
  for (int k = 0; k < poses; ++k) {
    const double side = k / 5 % 4, along = k % 5;
    const double yaw = 0.5 * std::numbers::pi * side;
    const Eigen::Vector2d corner(side == 0 || side == 3 ? 0.0 : 10.0, side < 2 ? 0.0 : 10.0);
    const Eigen::Vector2d p = corner + 2.0 * along * Eigen::Vector2d(std::cos(yaw), std::sin(yaw));
    truth.emplace_back(p.x(), p.y(), yaw);
    graph.poses.emplace_back(truth.back() +
                             Eigen::Vector3d(random.Normal(0.2), random.Normal(0.2), 0.0));
    if (k > 0) graph.edges.push_back(k % 2 == 0 ? edge(k - 1, k) : edge(k, k - 1));
    if (k >= 20) graph.edges.push_back(k % 3 == 0 ? edge(k, k - 20) : edge(k - 20, k));
    for (int j = 0; j < 2; ++j) {
      const Eigen::Vector3d d =
          seen_from(truth.back(), {landmarks[static_cast<std::size_t>(j)].x(),
                                   landmarks[static_cast<std::size_t>(j)].y(), 0.0});
      graph.sightings.push_back({.pose = k,
                                 .landmark = j,
                                 .bearing_range = {std::atan2(d.y(), d.x()) + random.Normal(0.03),
                                                   d.head<2>().norm() + random.Normal(0.1)},
                                 .sigma = {0.03, 0.1}});
    }
  }
  return graph;
}

TEST(PlanarRun, ReachesTheBatchMinimumThroughPlaces) {
  const SetResult result = RunPlanarGraph(SquareGraph(60, 0.1, 0.02), NoClock);
  EXPECT_EQ(result.places, 40);
  EXPECT_TRUE(result.finish.has_converged);
  EXPECT_LT(result.Excess(), 1e-6);
}

TEST(PlanarRun, ConvergesThoughTheNewestPosesWouldRatherMoveAlone) {
  // The newest poses hang on one another and on closures alone; were they moved before the step as
  // a whole is judged, the way back would be lost.
  PlanarGraph graph = SquareGraph(31, 0.1, 0.2);
  graph.sightings.clear();
  const SetResult result = RunPlanarGraph(graph, NoClock);
  EXPECT_TRUE(result.finish.has_converged);
  EXPECT_LT(result.Excess(), 1e-6);
}

TEST(PlanarRun, NeverLeavesTheSmootherWorseThanItWas) {
  // Odometry that says next to nothing, so that whole steps overshoot.
  for (const int poses : {18, 25, 31, 40, 46, 60}) {
    PlanarGraph graph = SquareGraph(poses, 1.0, 1.0);
    std::erase_if(graph.edges, [](const auto& e) { return std::abs(e.from - e.to) > 1; });
    const SetResult result = RunPlanarGraph(graph, NoClock);
    EXPECT_LE(result.cost, result.running_cost * (1.0 + 1e-9)) << poses;
  }
}

TEST(RangeRun, FindsBeaconsAndPosesFromOdometryAndRanges) {
  Random random(5);
  RangeSession session;
  session.beacons = {{3, {30.0, 10.0}}, {7, {-10.0, 25.0}}, {8, {10.0, -20.0}}};
  Eigen::Vector3d x = Eigen::Vector3d::Zero();
  session.truth.emplace_back(0.0, 0.0, 0.0, 0.0);
  for (int k = 1; k <= 800; ++k) {
    const double way = 0.3, turn = 0.012 + 0.02 * std::sin(0.02 * k);
    const double heading = x.z() + 0.5 * turn;
    x += Eigen::Vector3d(way * std::cos(heading), way * std::sin(heading), turn);
    session.truth.emplace_back(k, x.x(), x.y(), x.z());
    session.steps.push_back(
        {static_cast<double>(k), way + random.Normal(0.03), turn + random.Normal(0.002)});
    const auto beacon = std::next(session.beacons.begin(), k % 3);
    const double range = 1.05 * (beacon->second - x.head<2>()).norm() + random.Normal(0.3);
    session.ranges.push_back({static_cast<double>(k), beacon->first, range});
  }
  const SetResult result =
      RunRangeSession(session, {.range_sigma = 0.5, .has_own_scale = true}, NoClock);
  const SetError error = ErrorOfRangeSession(result, session);
  EXPECT_LT(result.Excess(), 1e-6);
  ASSERT_EQ(result.beacons.size(), 3U);
  EXPECT_LT(error.worst_beacon, 1.0);
  EXPECT_LT(error.poses, 0.6);
}

std::vector<RangeFrom> RangesTo(const Eigen::Vector2d& beacon,
                                const std::vector<Eigen::Vector2d>& places) {
  std::vector<RangeFrom> ranges;
  for (const Eigen::Vector2d& from : places)
    ranges.push_back({from, (beacon - from).norm()});
  return ranges;
}

TEST(StartOfBeacon, IsWhereTheRangesMeet) {
  std::vector<Eigen::Vector2d> places;
  for (int i = 0; i < 20; ++i)
    places.emplace_back(i, 0.05 * i * i);
  const auto start = StartOfBeacon(RangesTo({12.0, -9.0}, places), 0.5);
  ASSERT_TRUE(start);
  EXPECT_LT((*start - Eigen::Vector2d(12.0, -9.0)).norm(), 0.01);
}
TEST(StartOfBeacon, WaitsWhileTheMirroredPlaceFitsAsWell) {
  std::vector<Eigen::Vector2d> places;
  for (int i = 0; i < 40; ++i)
    places.emplace_back(i, 0.0);
  EXPECT_FALSE(StartOfBeacon(RangesTo({12.0, -9.0}, places), 0.5));
}
TEST(StartOfBeacon, WaitsWhileTheWayIsShort) {
  std::vector<Eigen::Vector2d> places;
  for (int i = 0; i < 40; ++i)
    places.emplace_back(0.01 * i, 0.01 * (i % 7));
  EXPECT_FALSE(StartOfBeacon(RangesTo({12.0, -9.0}, places), 0.5));
}

class SetFileTest : public ::testing::Test {
 protected:
  std::filesystem::path Write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name) << text;
    return folder_.path() / name;
  }
  TemporaryFolder folder_;
};

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

/// A MATLAB 5 file with one matrix [1 3; 2 4] named m.
std::string MatlabFile() {
  const auto word = [](std::uint32_t value) {
    return std::string(reinterpret_cast<const char*>(&value), 4);
  };
  std::string content = word(6) + word(8) + word(6) + word(0);  // flags: doubles
  content += word(5) + word(8) + word(2) + word(2);             // two by two
  content += word((1U << 16U) | 1U) + "m" + std::string(3, '\0');
  content += word(9) + word(32);
  for (const double value : {1.0, 2.0, 3.0, 4.0})
    content += std::string(reinterpret_cast<const char*>(&value), 8);
  return std::string(128, ' ') + word(14) + word(static_cast<std::uint32_t>(content.size())) +
         content;
}

TEST_F(SetFileTest, AMatlabMatrixIsReadByColumns) {
  const auto matrices = ReadMatlabMatrices(Write("a.mat", MatlabFile()));
  ASSERT_TRUE(matrices) << matrices.error().text;
  const Eigen::Matrix2d expected = (Eigen::Matrix2d() << 1.0, 3.0, 2.0, 4.0).finished();
  EXPECT_EQ(matrices->at("m"), expected);
}
TEST_F(SetFileTest, AMatlabFileThatIsCutShortIsAnErrorWithItsPlace) {
  const std::string whole = MatlabFile();
  for (std::size_t size = 129; size < whole.size(); ++size) {
    const auto matrices = ReadMatlabMatrices(Write("a.mat", whole.substr(0, size)));
    ASSERT_FALSE(matrices) << size;
    EXPECT_THAT(matrices.error().text, HasSubstr("damaged at byte 128"));
  }
  EXPECT_FALSE(ReadMatlabMatrices(Write("a.mat", "short")));
}

}  // namespace
}  // namespace limpet
