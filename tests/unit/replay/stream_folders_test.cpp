// SPDX-License-Identifier: MIT
// The estimator against the recorded streams and the figures of their README.
#include <filesystem>

#include <gtest/gtest.h>

#include "estimation/replay/replay.hpp"
#include "tests/support/trajectory_error.hpp"

namespace limpet {
namespace {

struct Expectation {
  const char* folder;
  double smoothed, online, opi_max;  ///< aligned [m]

  friend void PrintTo(const Expectation& expected, std::ostream* out) { *out << expected.folder; }
};

class SharedStream : public ::testing::TestWithParam<Expectation> {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(LIMPET_SOURCE_DIR).parent_path() / "shared/slam-streams" /
              GetParam().folder;
    if (!std::filesystem::exists(folder_)) {
      GTEST_SKIP() << folder_ << " is not there";
    }
    const Expected<SensorStream> stream = LoadSensorStream(folder_);
    ASSERT_TRUE(stream.has_value());
    result_ = Replay(*stream, ParamsForStream(stream->meta), [] { return 0.0; });
    truth_ = LoadTruth(folder_);
  }
  std::filesystem::path folder_;
  ReplayResult result_;
  StreamTruth truth_;
};

TEST_P(SharedStream, IsSmoothedAsWellAsByTheReference) {
  EXPECT_LE(ErrorOf(result_.smoothed, truth_).aligned, 1.03 * GetParam().smoothed);
}

TEST_P(SharedStream, IsFollowedOnlineAsWellAsByTheReference) {
  EXPECT_LE(ErrorOf(result_.online, truth_).aligned, 1.1 * GetParam().online);
}

TEST_P(SharedStream, ShowsEveryObjectOnceAndNothingElse) {
  const auto errors =
      ErrorsOf(result_.landmarks, ErrorOf(result_.smoothed, truth_).alignment, truth_);
  EXPECT_EQ(errors.duplicates, 0);
  EXPECT_EQ(errors.false_ones, 0);
  EXPECT_TRUE(errors.missed.empty());
  EXPECT_LE(errors.aligned_max, 1.1 * GetParam().opi_max);
}

TEST_P(SharedStream, ConvergesAndLeavesNoGapOverASecond) {
  EXPECT_TRUE(result_.finish.has_converged);
  for (std::size_t i = 1; i < result_.smoothed.size(); ++i) {
    ASSERT_LE(result_.smoothed[i].t - result_.smoothed[i - 1].t, 1.0 + 1e-6);
  }
}

// Figures of slam-streams/README.md, associations from the truth.
INSTANTIATE_TEST_SUITE_P(Table1, SharedStream,
                         ::testing::Values(Expectation{"a-table1-discovery", 0.078, 0.096, 0.11},
                                           Expectation{"b-table1-change", 0.049, 0.099, 0.21}),
                         [](const auto& session) {
                           return std::string(1, session.param.folder[0]);
                         });

}  // namespace
}  // namespace limpet
