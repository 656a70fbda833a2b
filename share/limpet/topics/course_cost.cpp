// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "limpet/topics/energy.hpp"

namespace limpet {

double CourseCost::At(double course) const {
  if (metres.empty()) return 1.0;
  const auto count = static_cast<double>(metres.size());
  const double turns = course / (2.0 * std::numbers::pi);
  const double place = (turns - std::floor(turns)) * count;
  const auto before = static_cast<std::size_t>(place) % metres.size();
  const double share = place - std::floor(place);
  return (1.0 - share) * metres[before] + share * metres[(before + 1) % metres.size()];
}

}  // namespace limpet
