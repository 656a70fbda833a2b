// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/app/app.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

const Topic<double> kMeasured{"MEASURED", "a measurement"};
const Topic<bool> kAsked{"ASKED", "a command", true};

/// Keeps the times of what reached it.
class StampTaker final : public App {
 public:
  explicit StampTaker(const AppContext& context) : App(context) {
    Subscribe(kMeasured, &StampTaker::OnMeasured);
    Subscribe(kAsked, &StampTaker::OnAsked);
  }
  std::vector<Seconds> measured, asked;

 private:
  void OnMeasured(const Stamped<double>& value) { measured.push_back(value.time); }
  void OnAsked(const Stamped<bool>& value) { asked.push_back(value.time); }
};

class StampGuardTest : public ::testing::Test {
 protected:
  AppContext ContextAtWarp(double warp) {
    AppContext context;
    context.name = "pTaker";
    context.link = &link_;
    context.warp = warp;
    return context;
  }
  void Measure(StampTaker& app, double ahead) {
    link_.SendStamped(app, kMeasured, 1.0, link_.time + Seconds(ahead));
  }
  TestLink link_;
  StampTaker app_{ContextAtWarp(1.0)};
};

TEST_F(StampGuardTest, RefusesWhatIsStampedInTheFutureAndNamesIt) {
  Measure(app_, 3600.0);
  EXPECT_TRUE(app_.measured.empty());
  ASSERT_TRUE(app_.warnings().contains("STAMP_FROM_FUTURE_MEASURED"));
  EXPECT_THAT(app_.warnings().at("STAMP_FROM_FUTURE_MEASURED").text,
              testing::HasSubstr("3600.0 s"));
}

TEST_F(StampGuardTest, RefusesTimesThatAreNoNumber) {
  Measure(app_, std::nan(""));
  Measure(app_, std::numeric_limits<double>::infinity());
  Measure(app_, -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(app_.measured.empty());
}

TEST_F(StampGuardTest, TakesWhatIsLateOrAheadByNoMoreThanClocksDiffer) {
  Measure(app_, -3600.0);
  Measure(app_, 0.4);
  EXPECT_EQ(app_.measured.size(), 2U);
  EXPECT_TRUE(app_.warnings().empty());
}

TEST_F(StampGuardTest, ClearsTheWarningOnceStampsAreRightAgainForAWhile) {
  Measure(app_, 10.0);
  link_.time += Seconds(1.0);
  Measure(app_, 0.0);
  EXPECT_TRUE(app_.warnings().contains("STAMP_FROM_FUTURE_MEASURED"));
  link_.time += Seconds(2.0);
  Measure(app_, 0.0);
  EXPECT_TRUE(app_.warnings().empty());
  EXPECT_EQ(app_.measured.size(), 2U);
}

TEST_F(StampGuardTest, CountsInTheReportWhatItRefused) {
  app_.StartReporting({});
  for (int i = 0; i < 3; ++i) {
    Measure(app_, 3600.0 + i);
  }
  link_.published.clear();
  app_.End(link_.time);
  ASSERT_FALSE(link_.published.empty());
  EXPECT_THAT(std::get<std::string>(link_.published.back()->value),
              testing::HasSubstr("3 of MEASURED stamped in the future, up to 3602.0 s"));
}

TEST_F(StampGuardTest, AllowsTheSameRealTimeAtAnyWarp) {
  StampTaker fast(ContextAtWarp(10.0));
  Measure(fast, 4.0);
  EXPECT_EQ(fast.measured.size(), 1U);
  Measure(fast, 6.0);
  EXPECT_EQ(fast.measured.size(), 1U);
}

TEST_F(StampGuardTest, ObeysACommandWhateverTheClockOfItsSender) {
  for (const double off : {3600.0, -2000.0, std::nan("")}) {
    link_.SendStamped(app_, kAsked, true, link_.time + Seconds(off));
  }
  EXPECT_EQ(app_.asked, std::vector<Seconds>(3, link_.time));
  EXPECT_TRUE(app_.warnings().empty());
}

}  // namespace
}  // namespace limpet
