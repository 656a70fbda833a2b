#include "BHV_Template.hpp"

#include <gtest/gtest.h>

namespace {

/// What it bids on a line of 10 m to the north that begins `east` of the place.
double BidOnALineAt(double east) {
  BHV_Template behavior({.north = limpet::Meters(5.0), .east = limpet::Meters(0.0)});
  const limpet::Option line{.source = "test",
                            .path = limpet::DubinsPath({.north = 0.0, .east = east},
                                                       {{.curvature = 0.0, .length = 10.0}})};
  return behavior.Value({line, {}}, {})->value;
}

TEST(BHV_Template, ChargesForMetresNearThePlace) {
  EXPECT_NEAR(BidOnALineAt(0.0), -10.0, 0.5) << "all of it";
  EXPECT_NEAR(BidOnALineAt(4.0), -6.0, 0.5) << "a chord of 6 m";
}

TEST(BHV_Template, SaysNothingAgainstOtherPaths) { EXPECT_EQ(BidOnALineAt(6.0), 0.0); }

}  // namespace
