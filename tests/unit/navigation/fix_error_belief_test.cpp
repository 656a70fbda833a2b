// SPDX-License-Identifier: MIT
#include "estimation/navigation/fix_error_belief.hpp"

#include <cmath>
#include <cstdint>
#include <optional>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"

namespace limpet {
namespace {

using namespace literals;

constexpr double kStated = 0.4;  // [m]

/// What fixes truly are: what wanders, for how long it stays the same, and noise.
struct TrueError {
  double wander = 0.4;         // [m]
  double correlation = 120.0;  // [s]
  double noise = 0.05;         // [m]
};

class Receiver {
 public:
  Receiver(const TrueError& error, std::uint64_t seed) : error_(error), random_(seed, "fixes") {}
  /// What fixes of so long a stay are off where dead reckoning has no error.
  void Stay(FixErrorBelief& belief, int seconds,
            const std::optional<FixErrorBelief::Start>& known) {
    off_W_ = {random_.Normal(error_.wander), random_.Normal(error_.wander)};
    const Eigen::Vector2d first = off_W_;
    auto start = known;
    if (start) start->off_W += first;
    belief.BeginStay(start);
    const double keep = std::exp(-1.0 / error_.correlation);
    const double change = error_.wander * std::sqrt(1.0 - keep * keep);
    for (int i = 0; i < seconds; ++i) {
      off_W_ = keep * off_W_ + Eigen::Vector2d(random_.Normal(change), random_.Normal(change));
      const Eigen::Vector2d noise(random_.Normal(error_.noise), random_.Normal(error_.noise));
      belief.Add({.t = t_, .off_W = off_W_ + noise, .sd = kStated, .drift = 2.5e-5});
      t_ += 1.0;
    }
    t_ += 1000.0;
  }

 private:
  TrueError error_;
  Random random_;
  Eigen::Vector2d off_W_ = Eigen::Vector2d::Zero();
  double t_ = 0.0;
};

/// Mean over seeds of what one stay of so long makes of the sigma.
double ScaleAfter(const TrueError& error, int seconds) {
  constexpr int kSeeds = 60;
  double mean = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    FixErrorBelief belief(120.0_s);
    Receiver(error, seed).Stay(belief, seconds, std::nullopt);
    mean += belief.Scale() / kSeeds;
  }
  return mean;
}

TEST(FixErrorBelief, AReceiverThatIsAsItStatesIsBelieved) {
  EXPECT_LT(ScaleAfter({}, 45), 1.15);
  EXPECT_LT(ScaleAfter({}, 150), 1.12);
  EXPECT_GE(ScaleAfter({.wander = 0.1}, 60), 0.95) << "one that is better is not believed more";
}

TEST(FixErrorBelief, OneThatIsFiveTimesWorseIsFoundOutWithinAMinute) {
  EXPECT_GT(ScaleAfter({.wander = 2.0}, 45), 4.0);
  EXPECT_LT(ScaleAfter({.wander = 2.0}, 45), 7.5);
  EXPECT_GT(ScaleAfter({.wander = 2.0, .noise = 0.3}, 60), 3.5);
}

TEST(FixErrorBelief, NoiseThatDiffersFromFixToFixIsNoErrorOfThePlace) {
  EXPECT_LT(ScaleAfter({.wander = 0.35, .noise = 0.2}, 60), 1.1);
  EXPECT_LT(ScaleAfter({.wander = 0.35, .noise = 1.0}, 60), 1.8);
}

TEST(FixErrorBelief, AnErrorThatStaysForLongShowsBetweenStays) {
  double one = 0.0, four = 0.0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    FixErrorBelief belief(120.0_s);
    Receiver receiver({.wander = 2.0, .correlation = 3600.0}, seed);
    receiver.Stay(belief, 45, std::nullopt);
    one += belief.Scale() / 40.0;
    for (int i = 0; i < 3; ++i)
      receiver.Stay(belief, 45, FixErrorBelief::Start{.variance = 0.04});
    four += belief.Scale() / 40.0;
  }
  EXPECT_LT(one, 2.5) << "what does not show is not known";
  EXPECT_GT(four, 3.0);
}

TEST(FixErrorBelief, OneStartThatIsFarOffIsNotTheReceiversFault) {
  FixErrorBelief belief(120.0_s);
  belief.BeginStay(FixErrorBelief::Start{.off_W = {9.0, 0.0}, .variance = 1.0});
  for (int i = 0; i < 60; ++i)
    belief.Add({.t = 1.0 * i, .off_W = {0.0, 0.0}, .sd = kStated, .drift = 2.5e-5});
  EXPECT_LT(belief.Scale(), 1.5);
}

TEST(FixErrorBelief, FixesThatAreTakenBackAreForgotten) {
  FixErrorBelief belief(120.0_s), fresh(120.0_s);
  Receiver({.wander = 4.0}, 1).Stay(belief, 60, std::nullopt);
  EXPECT_GT(belief.Scale(), 4.0);
  belief.RestartStay();
  EXPECT_DOUBLE_EQ(belief.Scale(), fresh.Scale());
}

}  // namespace
}  // namespace limpet
