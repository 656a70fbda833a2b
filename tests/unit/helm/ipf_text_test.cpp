// SPDX-License-Identifier: MIT
// Bids as displays of MOOS-IvP read them: decoded again, they are what the helm adds up.
#include "limpet/helm/ipf_text.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/config.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

/// A function as a reader of the text has it.
struct ReadFunction {
  struct Box {
    std::vector<int> low, high;
    std::vector<double> weights;
  };
  std::string context;
  double weight = 0.0;
  std::vector<std::string> variables;
  std::vector<int> points;
  std::vector<Box> boxes;

  /// The value at a point, and in how many boxes it lies.
  [[nodiscard]] std::pair<double, int> At(const std::vector<int>& at) const {
    double value = 0.0;
    int times = 0;
    for (const Box& box : boxes) {
      bool is_in = true;
      for (std::size_t d = 0; d < at.size(); ++d) {
        is_in = is_in && at[d] >= box.low[d] && at[d] <= box.high[d];
      }
      if (!is_in) continue;
      ++times;
      value = box.weights.back();
      for (std::size_t d = 0; d < at.size(); ++d) {
        value += box.weights[d] * at[d];
      }
    }
    return {value, times};
  }
};

/// Fields by position, as the readers take them; throws if one is not there or is no number.
ReadFunction Read(const std::string& text) {
  const std::vector<std::string> fields = Split(text, ',');
  std::size_t next = 0;
  const auto take = [&] { return fields.at(next++); };
  const auto number = [&] { return ParseNumber(take()).value(); };
  const auto whole = [&] { return static_cast<int>(number()); };
  ReadFunction function;
  EXPECT_EQ(take(), "H");
  const int length = whole();
  function.context = take();
  EXPECT_EQ(static_cast<int>(function.context.size()), length);
  const auto dimensions = static_cast<std::size_t>(whole());
  const int boxes = whole();
  EXPECT_EQ(whole(), 1) << "pieces are planes";
  function.weight = number();
  EXPECT_EQ(take(), "D");
  for (const std::string& variable : Split(take(), ':')) {
    const std::vector<std::string> parts = Split(variable, ';');
    function.variables.push_back(parts.at(0));
    function.points.push_back(static_cast<int>(ParseNumber(parts.at(3)).value()));
  }
  EXPECT_EQ(function.variables.size(), dimensions);
  EXPECT_EQ(take(), "G");
  for (std::size_t d = 0; d < dimensions; ++d) {
    EXPECT_EQ(whole(), function.points.at(d) - 1);
  }
  EXPECT_EQ(take(), "F");
  for (int i = 0; i < boxes; ++i) {
    ReadFunction::Box box;
    for (std::size_t d = 0; d < dimensions; ++d) {
      box.low.push_back(whole()), box.high.push_back(whole());
    }
    for (std::size_t d = 0; d <= dimensions; ++d) {
      box.weights.push_back(number());
    }
    function.boxes.push_back(box);
  }
  EXPECT_EQ(next, fields.size());
  return function;
}

MotionDomain IpfDomain() {
  MotionDomain domain;
  domain.speed = MotionAxis{.low = 0.0, .high = 1.0, .points = 21};
  domain.depth = MotionAxis{.low = 0.0, .high = 20.0, .points = 81};
  return domain;
}

TEST(IpfText, OfPeaksIsWhatTheHelmAddsUp) {
  const MotionDomain domain = IpfDomain();
  OwnedMotionBid owned{.owner = "go", .weight = 60.0, .bid = {}};
  // Over north, and between the domain's points.
  owned.bid.course =
      Peak{.summit = 0.05, .flat_half_width = 0.1, .base_half_width = 2.0, .share = 0.5};
  owned.bid.speed = Peak{.summit = 0.52, .flat_half_width = 0.0, .base_half_width = 0.3};
  const ReadFunction read = Read(IpfText(owned, domain, 7));
  EXPECT_EQ(read.context, "7:go");
  EXPECT_THAT(read.variables, ::testing::ElementsAre("course", "speed"));
  EXPECT_LT(read.boxes.size(), 100U);
  for (int course = 0; course < 360; ++course) {
    for (int speed = 0; speed < 21; ++speed) {
      const double north = std::abs(WrapAngle(domain.course->At(course) - 0.05));
      const double wanted =
          60.0 * (0.5 * PeakValue(*owned.bid.course, north) +
                  PeakValue(*owned.bid.speed, std::abs(domain.speed->At(speed) - 0.52)));
      const auto [value, times] = read.At({course, speed});
      ASSERT_EQ(times, 1) << course << ", " << speed;
      ASSERT_NEAR(read.weight * value / 100.0, wanted, 60.0 * 1e-3) << course << ", " << speed;
      ASSERT_GE(value, -0.05);
      ASSERT_LE(value, 100.05);
    }
  }
}

TEST(IpfText, OfATableIsNearItEverywhereAndCrossedWithOtherPeaks) {
  const MotionDomain domain = IpfDomain();
  MotionTable table(domain, {MotionVariable::kCourse, MotionVariable::kSpeed});
  const auto obstacle = [](double course, double speed) {
    const double off = std::abs(WrapAngle(course - 1.0));
    return off < 0.4 ? 0.3 * (1.0 - speed) : std::min(1.0, off / 2.0);
  };
  table.Fill([&](const MotionPoint& at) { return obstacle(at.course, at.speed); });
  OwnedMotionBid owned{.owner = "avoid", .weight = 100.0, .bid = {}};
  owned.bid.table = &table;
  owned.bid.depth = Peak{.summit = 3.0, .flat_half_width = 1.0, .base_half_width = 4.0};
  const ReadFunction read = Read(IpfText(owned, domain, 1));
  EXPECT_THAT(read.variables, SizeIs(3));
  for (int course = 0; course < 360; course += 3) {
    for (int speed = 0; speed < 21; speed += 2) {
      for (int depth = 0; depth < 81; depth += 5) {
        const double wanted = obstacle(domain.course->At(course), domain.speed->At(speed)) +
                              PeakValue(*owned.bid.depth, std::abs(domain.depth->At(depth) - 3.0));
        const auto [value, times] = read.At({course, speed, depth});
        ASSERT_EQ(times, 1);
        ASSERT_NEAR(read.weight * value / 100.0, 100.0 * wanted, 1.1);
      }
    }
  }
}

TEST(IpfText, OfABidOnNothingIsEmpty) {
  EXPECT_EQ(IpfText({.owner = "timer", .weight = 100.0, .bid = {}}, IpfDomain(), 1), "");
  MotionDomain without_depth = IpfDomain();
  without_depth.depth.reset();
  OwnedMotionBid dive{.owner = "dive", .weight = 100.0, .bid = {}};
  dive.bid.depth = Peak{.summit = 3.0};
  EXPECT_EQ(IpfText(dive, without_depth, 1), "") << "of a variable that nobody decides";
}

TEST(IpfPackets, AreCutAtTwoThousandBytesAndJoinAgain) {
  std::string text(5000, 'x');
  text.front() = 'H', text.back() = 'z';
  const std::vector<std::string> packets = IpfPackets(text, "waypt_survey", 12);
  ASSERT_THAT(packets, SizeIs(3));
  std::string joined;
  for (std::size_t i = 0; i < packets.size(); ++i) {
    const std::string head = "P,waypt_survey^12,3," + std::to_string(i + 1) + ",";
    EXPECT_THAT(packets[i], StartsWith(head));
    EXPECT_LE(packets[i].size(), 2000U);
    joined += packets[i].substr(head.size());
  }
  EXPECT_EQ(joined, text);
  EXPECT_THAT(IpfPackets("", "none", 1), IsEmpty());
}

}  // namespace
}  // namespace limpet
