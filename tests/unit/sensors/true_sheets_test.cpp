// SPDX-License-Identifier: MIT
#include "limpet/sensors/true_sheets.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

constexpr SheetErrorParams kTwiceTheNoise{.noise_factor = 2.0, .bias_factor = 1.0};
constexpr SheetErrorParams kHalfTheBias{.noise_factor = 1.0, .bias_factor = 0.5};

/// Sheets declare themselves: compares every key's text, and counts those that differ.
template <class Sheet>
int KeysThatDiffer(Sheet a, Sheet b) {
  ParamCollector of_a, of_b;
  a.Describe(of_a), b.Describe(of_b);
  const auto specs_a = of_a.specs(), specs_b = of_b.specs();
  int differ = 0;
  for (std::size_t i = 0; i < specs_a.size(); ++i)
    differ += specs_a[i].default_text != specs_b[i].default_text ? 1 : 0;
  return differ;
}

template <class Sheet>
void ExpectChanges(int by_noise, int by_bias) {
  const Sheet said;
  EXPECT_EQ(KeysThatDiffer(said, TrueSheet(said, SheetErrorParams{})), 0);
  EXPECT_EQ(KeysThatDiffer(said, TrueSheet(said, kTwiceTheNoise)), by_noise);
  EXPECT_EQ(KeysThatDiffer(said, TrueSheet(said, kHalfTheBias)), by_bias);
}

TEST(TrueSheets, AreTheFilesUnlessTheScenarioSaysOtherwise) {
  ExpectChanges<ImuSheet>(2, 3);
  ExpectChanges<FogSheet>(1, 1);
  ExpectChanges<DvlSheet>(4, 3);
  ExpectChanges<DepthSheet>(1, 1);
}

TEST(TrueSheets, ScaleWhatTheySay) {
  EXPECT_DOUBLE_EQ(TrueSheet(DvlSheet{}, kTwiceTheNoise).noise_mps, 2.0 * DvlSheet{}.noise_mps);
  EXPECT_DOUBLE_EQ(TrueSheet(ImuSheet{}, kHalfTheBias).heading_sigma.value(),
                   0.5 * ImuSheet{}.heading_sigma.value());
  EXPECT_DOUBLE_EQ(TrueSheet(FogSheet{}, kHalfTheBias).bias_deg_per_h,
                   0.5 * FogSheet{}.bias_deg_per_h);
  EXPECT_DOUBLE_EQ(TrueSheet(DepthSheet{}, kTwiceTheNoise).noise_m, 2.0 * DepthSheet{}.noise_m);
}

}  // namespace
}  // namespace limpet
