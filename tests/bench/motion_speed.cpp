// SPDX-License-Identifier: MIT
// motion_speed: what a decision on course, speed and depth costs at 360 x 41 x 50 points, beside
// looking at every point with every bid's function asked anew, in the same run, and whether both
// find the same. Times are of this thread's processor.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "limpet/core/clock.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/random.hpp"
#include "limpet/core/statistics.hpp"
#include "limpet/core/units.hpp"
#include "limpet/helm/motion_decision.hpp"

namespace {

using namespace limpet;
using enum MotionVariable;

constexpr double kWide = std::numbers::pi;

MotionDomain Domain() {
  return {.course = MotionAxis{.low = 0.0, .high = RadiansFromDegrees(359.0), .points = 360},
          .speed = MotionAxis{.low = 0.0, .high = 4.0, .points = 41},
          .depth = MotionAxis{.low = 0.0, .high = 49.0, .points = 50}};
}

/// A behavior with peaks and a table, both drawn.
class Drawn final : public Behavior {
 public:
  Drawn(Random& random, const MotionDomain& domain, std::vector<MotionVariable> over) {
    const auto draw = [&](double low, double high, double base) {
      return Peak{.summit = random.Uniform(low, high),
                  .flat_half_width = 0.0,
                  .base_half_width = random.Uniform(0.2, 1.0) * base};
    };
    if (random.Chance(0.7)) bid_.course = draw(-kWide, kWide, kWide);
    if (random.Chance(0.7)) bid_.speed = draw(0.0, 4.0, 4.0);
    if (random.Chance(0.7)) bid_.depth = draw(0.0, 49.0, 49.0);
    if (over.empty()) return;
    table_.emplace(domain, over);
    table_->Fill([&random](const MotionPoint&) { return random.Uniform(0.0, 1.0); });
    bid_.table = &*table_;
  }
  [[nodiscard]] MotionBid Move(const VehicleState&) override { return bid_; }
  /// At the points i of course, speed and depth.
  [[nodiscard]] double At(const MotionPoint& point, const std::array<std::size_t, 3>& i) const {
    double value = 0.0;
    if (bid_.course)
      value += PeakValue(*bid_.course, WrapAngle(point.course - bid_.course->summit));
    if (bid_.speed) value += PeakValue(*bid_.speed, point.speed - bid_.speed->summit);
    if (bid_.depth) value += PeakValue(*bid_.depth, point.depth - bid_.depth->summit);
    if (table_) {
      const std::size_t index = table_->stride(kCourse) * i[0] + table_->stride(kSpeed) * i[1] +
                                table_->stride(kDepth) * i[2];
      value += static_cast<double>(table_->values()[index]);
    }
    return value;
  }

 private:
  MotionBid bid_;
  std::optional<MotionTable> table_;
};

/// The best sum over all points.
double BruteForce(const std::vector<WeightedBehavior>& running, const MotionDomain& domain) {
  double best = 0.0;
  for (int c = 0; c < domain.course->points; ++c) {
    for (int s = 0; s < domain.speed->points; ++s) {
      for (int d = 0; d < domain.depth->points; ++d) {
        const MotionPoint point{domain.course->At(c), domain.speed->At(s), domain.depth->At(d)};
        double sum = 0.0;
        for (const WeightedBehavior& behavior : running) {
          sum += behavior.weight *
                 static_cast<const Drawn*>(behavior.behavior)
                     ->At(point, {static_cast<std::size_t>(c), static_cast<std::size_t>(s),
                                  static_cast<std::size_t>(d)});
        }
        best = std::max(best, sum);
      }
    }
  }
  return best;
}

/// What the arbiter's decision is worth by the same reckoning, at the points it chose.
double Worth(const std::vector<WeightedBehavior>& running, const MotionDomain& domain,
             const MotionDecision& decision) {
  const auto nearest = [](const MotionAxis& axis, double value) {
    return static_cast<std::size_t>(std::lround((value - axis.low) / axis.step()));
  };
  const double course =
      *decision.course < -1e-9 ? *decision.course + 2.0 * kWide : *decision.course;
  const MotionPoint point{*decision.course, *decision.speed, *decision.depth};
  double sum = 0.0;
  for (const WeightedBehavior& behavior : running) {
    sum += behavior.weight * static_cast<const Drawn*>(behavior.behavior)
                                 ->At(point, {nearest(*domain.course, course),
                                              nearest(*domain.speed, *decision.speed),
                                              nearest(*domain.depth, *decision.depth)});
  }
  return sum;
}

struct Setting {
  const char* name;
  std::vector<std::vector<MotionVariable>> tables;  ///< of twelve behaviors; the others have peaks
};

void Measure(const Setting& setting) {
  constexpr int kBehaviors = 12, kDecisions = 200;
  const MotionDomain domain = Domain();
  Random random(5, setting.name);
  std::vector<std::unique_ptr<Drawn>> owned;
  std::vector<WeightedBehavior> running;
  for (std::size_t i = 0; i < kBehaviors; ++i) {
    const auto& over =
        i < setting.tables.size() ? setting.tables[i] : std::vector<MotionVariable>{};
    owned.push_back(std::make_unique<Drawn>(random, domain, over));
    running.push_back({fmt::format("b{}", i), random.Uniform(1.0, 100.0), owned.back().get()});
  }
  MotionArbiter arbiter(domain);
  static_cast<void>(arbiter.Decide(running, {}));
  std::vector<double> times;
  for (int i = 0; i < kDecisions; ++i) {
    const Seconds begin = ThreadTime();
    static_cast<void>(arbiter.Decide(running, {}));
    times.push_back((ThreadTime() - begin).value());
  }
  const Seconds begin = ThreadTime();
  const double best = BruteForce(running, domain);
  const double brute = (ThreadTime() - begin).value();
  const double found = Worth(running, domain, arbiter.Decide(running, {}));
  const double median = Quantile(times, 0.5);
  fmt::print("{:<34} {:7.3f} {:7.3f} {:10.1f} {:8.0f}   {}\n", setting.name, 1e3 * median,
             1e3 * Quantile(times, 0.99), 1e3 * brute, brute / median,
             found > best - 1e-9 * best ? "the same" : fmt::format("{} < {}", found, best));
}

}  // namespace

int main() {
  fmt::print("{:<34} {:>7} {:>7} {:>10} {:>8}   answer\n", "twelve behaviors, of these", "ms",
             "p99", "dense ms", "ratio");
  const std::vector<MotionVariable> pair{kCourse, kSpeed}, all{kCourse, kSpeed, kDepth};
  Measure({"one course x speed", {pair}});
  Measure({"three course x speed", {pair, pair, pair}});
  Measure({"one over all three", {all}});
  Measure({"one over all three, two of pairs", {all, pair, {kSpeed, kDepth}}});
  Measure({"three over all three", {all, all, all}});
  return 0;
}
