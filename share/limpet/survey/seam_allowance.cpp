// SPDX-License-Identifier: MIT
#include "limpet/survey/seam_allowance.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/core/probability.hpp"

namespace limpet {
namespace {

/// Mean of how far a standard normal variable exceeds `z`, where it does.
double MeanExcess(double z) { return StandardNormalDensity(z) - z * StandardNormalShareBelow(-z); }

}  // namespace

double SeamAllowance(Meters beside, Meters loss) {
  const double share = loss / beside;  // infinite where nothing is off
  if (!(share < MeanExcess(0.0))) return 0.0;
  double low = 0.0, high = 8.0;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (low + high);
    (MeanExcess(middle) > share ? low : high) = middle;
  }
  // The overlap of the two is twice what each is drawn in.
  return std::min(kMostSeamAllowance, 0.5 * high * beside.value());
}

}  // namespace limpet
