// SPDX-License-Identifier: MIT
#include "limpet/helm/rate_of_closure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "limpet/core/frames.hpp"

namespace limpet {
namespace {

/// What a course and a speed are worth, in parts of the most that there could be.
class Closing {
 public:
  Closing(const WantedClosure& wanted, double fastest) : wanted_(wanted), fastest_(fastest) {}

  [[nodiscard]] double Of(const MotionPoint& at) const {
    constexpr double kCloser = 0.8, kTooFast = 0.5;
    const double off = std::abs(WrapAngle(at.course - wanted_.bearing));
    const double lack = wanted_.speed - std::cos(off) * at.speed;
    const double miss = std::min(lack < 0.0 ? -kTooFast * lack : lack, 2.0 * fastest_);
    const double aside = off * std::max(at.speed, 0.0) / (std::numbers::pi * fastest_);
    return kCloser * (1.0 - miss / (2.0 * fastest_)) + (1.0 - kCloser) * (1.0 - aside);
  }

 private:
  WantedClosure wanted_;
  double fastest_;
};

}  // namespace

const MotionTable* RateOfClosure::Toward(const WantedClosure& wanted, const MotionDomain& domain) {
  if (!domain.course || !domain.speed || domain.speed->high <= 0.0) return nullptr;
  if (!table_ || table_->domain() != domain) {
    table_.emplace(domain, std::array{MotionVariable::kCourse, MotionVariable::kSpeed});
  }
  const Closing closing(wanted, domain.speed->high);
  double worst = std::numeric_limits<double>::infinity(), best = -worst;
  table_->Fill([&](const MotionPoint& at) {
    const double value = closing.Of(at);
    worst = std::min(worst, value);
    best = std::max(best, value);
    return 0.0;
  });
  const double range = best > worst ? best - worst : 1.0;
  table_->Fill([&](const MotionPoint& at) {
    return std::clamp((closing.Of(at) - worst) / range, 0.0, 1.0);
  });
  return &*table_;
}

}  // namespace limpet
