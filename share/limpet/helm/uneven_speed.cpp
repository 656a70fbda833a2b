// SPDX-License-Identifier: MIT
#include "limpet/helm/uneven_speed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace limpet {
namespace {

constexpr double kSlow = 0.1, kFaster = 0.4;  ///< [m/s]; the second beyond the wanted speed
constexpr double kFastValue = 0.2;

int NearestIndex(double speed, const MotionAxis& axis) {
  if (axis.points == 1) return 0;
  const double point = std::floor((speed - axis.low) / axis.step() + 0.5);
  return static_cast<int>(std::clamp(point, 0.0, axis.points - 1.0));
}

/// Points of the axis where the lines meet; of those that fall together the wanted speed's counts.
class Knees {
 public:
  Knees(const WantedSpeed& wanted, const MotionAxis& axis) {
    const int last = axis.points - 1, top = NearestIndex(wanted.speed, axis);
    const int slow = std::min(NearestIndex(kSlow, axis), top);
    const double faster = wanted.speed + kFaster;
    const int fast = std::max(NearestIndex(faster, axis), top);
    if (top != 0) Add(0, 0.0);
    if (slow != 0 && slow != top) Add(slow, wanted.slow_value);
    Add(top, 1.0);
    if (fast != top) Add(fast, faster < axis.high ? kFastValue : 0.0);
    if (last != fast) Add(last, 0.0);
  }
  [[nodiscard]] double At(int point) const {
    for (std::size_t i = 1; i < count_; ++i) {
      const Knee &from = knees_[i - 1], &to = knees_[i];
      if (point > to.point) continue;
      const double share =
          static_cast<double>(point - from.point) / static_cast<double>(to.point - from.point);
      return from.value + (to.value - from.value) * share;
    }
    return knees_[count_ - 1].value;
  }

 private:
  struct Knee {
    int point = 0;
    double value = 0.0;
  };
  void Add(int point, double value) { knees_.at(count_++) = {point, value}; }

  std::array<Knee, 5> knees_;
  std::size_t count_ = 0;
};

}  // namespace

const MotionTable* UnevenSpeed::Around(const WantedSpeed& wanted, const MotionDomain& domain) {
  if (!domain.speed) return nullptr;
  if (!table_ || table_->domain() != domain)
    table_.emplace(domain, std::array{MotionVariable::kSpeed});
  const MotionAxis& axis = *domain.speed;
  const Knees knees(wanted, axis);
  table_->Fill(
      [&](const MotionPoint& at) { return wanted.share * knees.At(NearestIndex(at.speed, axis)); });
  return &*table_;
}

}  // namespace limpet
