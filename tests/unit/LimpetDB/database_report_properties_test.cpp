// SPDX-License-Identifier: MIT
// When the database speaks of itself, at any warp and whatever its clocks do.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "apps/LimpetDB/database_report.hpp"
#include "limpet/core/clock.hpp"
#include "limpet/core/random.hpp"
#include "limpet/core/record.hpp"
#include "limpet/topics/wall_clock.hpp"

namespace limpet {
namespace {

const Seconds kReportStart(5000.0);

/// A broker whose report is asked every tenth of a real second.
struct WarpedDatabase {
  explicit WarpedDatabase(double time_warp) : warp(time_warp) {}
  /// Real times at which it wrote the variable, within so many real seconds.
  std::vector<double> TimesOf(const std::string& variable, double real_seconds) {
    std::vector<double> times;
    for (int tick = 0; tick <= 10.0 * real_seconds; ++tick) {
      const double real = 0.1 * tick;
      const auto words = report.Take(broker, kReportStart + Seconds(real * warp), UnixTime());
      if (std::ranges::count(words, variable, [](const auto& word) { return word.first; }) > 0)
        times.push_back(real);
    }
    return times;
  }
  double warp;
  Broker broker{{.community = "alpha", .hostname = "here", .limits = {}}, kReportStart};
  DatabaseReport report{"alpha", warp, "127.0.0.1:9000", kReportStart};
};

TEST(DatabaseReportProperties, ItsStatusComesEveryTwoRealSecondsAtAnyWarp) {
  for (const double warp : {0.5, 1.0, 10.0, 100.0}) {
    WarpedDatabase database(warp);
    const std::vector<double> times = database.TimesOf("LIMPETDB_STATUS", 20.0);
    ASSERT_GE(times.size(), 9U) << warp;
    ASSERT_LE(times.size(), 11U) << warp;
    for (std::size_t i = 1; i < times.size(); ++i)
      EXPECT_NEAR(times[i] - times[i - 1], 2.0, 0.11) << warp;
  }
}

TEST(DatabaseReportProperties, ItCastsOnceAtItsStartAndThenOnlyForThoseWhoLook) {
  WarpedDatabase database(1.0);
  EXPECT_EQ(database.TimesOf("APPCAST", 10.0), (std::vector<double>{0.0}));
  EXPECT_TRUE(database.TimesOf("APPCAST", 10.0).empty());
  database.report.OnRequest("node=alpha,app=LimpetDB,duration=5,key=me,thresh=any", kReportStart);
  const std::vector<double> times = database.TimesOf("APPCAST", 10.0);
  ASSERT_FALSE(times.empty());
  EXPECT_LE(times.back(), 5.0) << "nobody looks any more";
}

TEST(DatabaseReportProperties, AWarningLastsHalfARealMinuteAtAnyWarp) {
  for (const double warp : {0.5, 1.0, 10.0}) {
    WarpedDatabase database(warp);
    ++database.broker.counts().strangers;
    const std::vector<double> times = database.TimesOf("LIMPETDB_WARNINGS", 60.0);
    ASSERT_EQ(times.size(), 2U) << "raised and cleared, at warp " << warp;
    EXPECT_NEAR(times[0], 0.0, 0.01);
    EXPECT_NEAR(times[1], 30.1, 0.11);
  }
}

TEST(DatabaseReportProperties, ACountThatStaysRaisesNothing) {
  WarpedDatabase database(1.0);
  EXPECT_TRUE(database.TimesOf("LIMPETDB_WARNINGS", 60.0).empty());
}

/// A wall clock that is set now and then.
struct SetClock {
  double vehicle = 1.8e9, ahead = 0.0;
  int steps = 0;
  void Go(Random& random) {
    vehicle += random.Uniform(0.1, 5.0);
    if (!random.Chance(0.1)) return;
    const double step = (random.Chance(0.5) ? 1.0 : -1.0) * random.Uniform(0.6, 4000.0);
    ahead += step;
    ++steps;
  }
};

TEST(WallClockWatchProperties, EveryStepIsToldAtOnceWithItsNumberAndNothingElseButNowAndThen) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed, "clocks");
    SetClock clock;
    WallClockWatch watch;
    ASSERT_TRUE(watch.Look(Seconds(clock.vehicle), Seconds(clock.vehicle)));
    double told = clock.vehicle;
    for (int i = 0; i < 300; ++i) {
      const int before = clock.steps;
      clock.Go(random);
      const auto news = watch.Look(Seconds(clock.vehicle), Seconds(clock.vehicle + clock.ahead));
      const bool is_due = clock.vehicle - told >= WallClockWatch::kPeriod.value();
      ASSERT_EQ(news.has_value(), clock.steps > before || is_due) << i;
      if (!news) continue;
      told = clock.vehicle;
      const auto record = DecodeRecord<WallClock>(news->record);
      ASSERT_TRUE(record);
      EXPECT_EQ(record->steps, clock.steps);
      EXPECT_NEAR(record->ahead, clock.ahead, 1e-5);
      EXPECT_NEAR(record->wall - record->vehicle, record->ahead, 1e-5);
      EXPECT_EQ(news->warning.has_value(), std::abs(clock.ahead) > 0.5);
    }
  }
}

TEST(WallClockWatchProperties, AStepIsMoreThanHalfASecondEitherWay) {
  for (const double sign : {-1.0, 1.0}) {
    for (const double size : {0.49, 0.51}) {
      WallClockWatch watch;
      static_cast<void>(watch.Look(Seconds(1000.0), Seconds(1000.0)));
      const auto news = watch.Look(Seconds(1001.0), Seconds(1001.0 + sign * size));
      EXPECT_EQ(news.has_value(), size > 0.5) << sign * size;
    }
  }
}

}  // namespace
}  // namespace limpet
