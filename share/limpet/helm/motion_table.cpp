// SPDX-License-Identifier: MIT
#include "limpet/helm/motion_table.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limpet/core/frames.hpp"

namespace limpet {

MotionTable::MotionTable(const MotionDomain& domain, std::span<const MotionVariable> variables)
    : domain_(domain) {
  std::size_t size = 1;
  for (auto variable = kMotionVariables.rbegin(); variable != kMotionVariables.rend(); ++variable) {
    const std::size_t index = IndexOf(*variable);
    const std::optional<MotionAxis>& axis = domain.axis(*variable);
    const bool is_covered = axis && std::ranges::find(variables, *variable) != variables.end();
    coordinates_.at(index).assign(is_covered ? static_cast<std::size_t>(axis->points) : 1, 0.0);
    strides_.at(index) = is_covered ? size : 0;
    size *= coordinates_.at(index).size();
    for (int i = 0; is_covered && i < axis->points; ++i) {
      const double value = axis->At(i);
      coordinates_.at(index).at(static_cast<std::size_t>(i)) =
          *variable == MotionVariable::kCourse ? WrapAngle(value) : value;
    }
  }
  values_.assign(size, 0.0F);
}

std::optional<std::string> MotionTable::Problem() const {
  if (!unfit_) return std::nullopt;
  const std::string what = std::isfinite(unfit_->value)
                               ? fmt::format("{:g}, outside of 0 to 1,", unfit_->value)
                               : std::string(std::isnan(unfit_->value) ? "NaN" : "infinity");
  return fmt::format("{} in its function at course {:.1f} deg, speed {:g} m/s, depth {:g} m", what,
                     MoosHeadingFromYaw(unfit_->point.course), unfit_->point.speed,
                     unfit_->point.depth);
}

}  // namespace limpet
