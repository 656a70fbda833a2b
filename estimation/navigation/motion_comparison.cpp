// SPDX-License-Identifier: MIT
#include "estimation/navigation/motion_comparison.hpp"

#include <algorithm>
#include <span>

#include "limpet/core/cross_product.hpp"
#include "limpet/core/require.hpp"

namespace limpet {

MotionComparison::MotionComparison(const Params& params) : params_(params) {
  LIMPET_REQUIRE(params.stretches >= 3 && params.stretches <= kMost, "a median of some stretches");
  LIMPET_REQUIRE(params.beside <= params.stretches / 2, "beside the median, among the stretches");
}

void MotionComparison::Add(double t, const Eigen::Vector2d& way, const Eigen::Vector2d& other) {
  if (!now_ || !(t >= now_->to) || t - now_->to > params_.longest_pause.value()) {
    now_ = Stretch{.from = t, .to = t};
    return;
  }
  now_->to = t;
  now_->way += way;
  now_->other += other;
  if (t - now_->from < params_.stretch.value()) return;
  const Eigen::Vector2d a = now_->way, b = now_->other;
  now_ = Stretch{.from = t, .to = t};
  if (!(a.norm() >= params_.least) || !b.allFinite()) return;
  ratios_[count_++ % params_.stretches] =
      Eigen::Vector2d(a.dot(b), CrossOf(a, b)) / a.squaredNorm();
}

std::optional<MotionComparison::Ratio> MotionComparison::ratio() const {
  const std::size_t middle = params_.stretches / 2;
  if (count_ < params_.stretches) return std::nullopt;
  Ratio result;
  for (const Eigen::Index axis : {0, 1}) {
    std::array<double, kMost> values{};
    const auto sorted = std::span(values).first(params_.stretches);
    std::ranges::transform(std::span(ratios_).first(params_.stretches), sorted.begin(),
                           [axis](const Eigen::Vector2d& ratio) { return ratio(axis); });
    std::ranges::sort(sorted);
    result.median_H(axis) = sorted[middle];
    result.low_H(axis) = sorted[middle - params_.beside];
    result.high_H(axis) = sorted[middle + params_.beside];
  }
  return result;
}

}  // namespace limpet
