// SPDX-License-Identifier: MIT
// A mission of everyday behaviors alone, flown embedded: fix, dive, five waypoints, home.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/runs/session_runner.hpp"
#include "limpet/topics/simulation.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;

namespace fs = std::filesystem;

struct Flown {
  SessionOutcome outcome;
  std::vector<SimTruth> truth;           ///< all the way
  std::vector<double> reached;           ///< indices of waypoints, as REACHED says
  std::vector<std::string> ended;        ///< behaviors that have completed
  double lap_metres = 0.0, lap_s = 0.0;  ///< from the first waypoint to the last
};

Flown FlyAlpha() {
  const TemporaryFolder folder;
  const fs::path alpha = fs::path(LIMPET_SOURCE_DIR) / "missions" / "alpha";
  Flown flown;
  std::optional<Seconds> lap_begun;
  flown.outcome =
      RunSession(LoadMission(alpha / "mission.moos"),
                 {.session = "discovery",
                  .mission_folder = alpha,
                  .run_folder = folder.path() / "discovery",
                  .prior_folder = {},
                  .seed = 3,
                  .longest = Seconds(2000.0)},
                 [&](const Message& message) {
                   if (message.name == "REACHED") {
                     flown.reached.push_back(std::get<double>(message.value));
                     if (!lap_begun) lap_begun = message.time;
                     flown.lap_s = (message.time - *lap_begun).value();
                   }
                   if (message.name == "IVPHELM_LIFE_EVENT") {
                     const std::string& text = std::get<std::string>(message.value);
                     const std::size_t name = text.find("bname=") + 6;
                     if (text.find("event=death") != std::string::npos) {
                       flown.ended.push_back(text.substr(name, text.find(',', name) - name));
                     }
                   }
                   if (message.name != topics::kSimTruth.name) return;
                   const auto truth = TopicCodec<SimTruth>::Decode(message.value);
                   if (!flown.truth.empty() && lap_begun && flown.reached.size() < 5) {
                     flown.lap_metres += std::hypot(truth->north - flown.truth.back().north,
                                                    truth->east - flown.truth.back().east);
                   }
                   flown.truth.push_back(*truth);
                 });
  return flown;
}

TEST(AlphaMission, TravelsItsLapUnderWaterAndComesHome) {
  const Flown flown = FlyAlpha();
  ASSERT_EQ(flown.outcome.ended, "home") << flown.outcome.cut.value_or("");
  EXPECT_THAT(flown.reached, ElementsAre(0.0, 1.0, 2.0, 3.0, 4.0));
  EXPECT_THAT(flown.ended, ElementsAre("fix", "lap", "home"));
  const double lap = 120.0 + 90.0 + 2.0 * std::hypot(30.0, 60.0);
  EXPECT_NEAR(flown.lap_metres, lap, 0.03 * lap);
  EXPECT_NEAR(flown.lap_s, lap / 0.8, 0.05 * lap / 0.8);
  const SimTruth& first = flown.truth.front();
  const SimTruth& last = flown.truth.back();
  EXPECT_LT(std::hypot(last.north - first.north, last.east - first.east), 5.0);
  EXPECT_NEAR(std::ranges::max_element(flown.truth, {}, &SimTruth::down)->down, 3.0, 0.3);
}

TEST(AlphaMission, IsTheSameEachTimeItIsFlown) {
  const Flown one = FlyAlpha(), other = FlyAlpha();
  ASSERT_THAT(one.truth, Not(IsEmpty()));
  ASSERT_EQ(one.truth.size(), other.truth.size());
  EXPECT_EQ(one.truth.back().north, other.truth.back().north);
  EXPECT_EQ(one.truth.back().east, other.truth.back().east);
}

}  // namespace
}  // namespace limpet
