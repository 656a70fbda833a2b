// SPDX-License-Identifier: MIT
#include "limpet/runs/run_settings.hpp"

#include <gtest/gtest.h>

#include "estimation/mapping/map_params.hpp"

namespace limpet {
namespace {

TEST(RunSettings, TakesTheVehicleToMapFromAsHighAsPMapDoesWhereTheMissionSaysNothing) {
  EXPECT_EQ(ReportSettings{}.highest_view_m, MapParams{}.highest_view.value());
}

}  // namespace
}  // namespace limpet
