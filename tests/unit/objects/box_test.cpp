// SPDX-License-Identifier: MIT
#include "limpet/objects/box.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

const CameraModel kCamera;  // 640 x 480

Box BoxBetween(double left, double top, double right, double bottom) {
  return {.u = 0.5 * (left + right),
          .v = 0.5 * (top + bottom),
          .w = right - left,
          .h = bottom - top,
          .color = "yellow"};
}

TEST(BoxExtent, OfABoxInTheMiddleIsWhole) {
  const Box box = BoxBetween(100, 50, 180, 120);
  EXPECT_FALSE(IsCut(box, kCamera));
  const BoxExtent across = ExtentAcross(box, kCamera), along = ExtentAlong(box, kCamera);
  EXPECT_EQ(across.low, 100);
  EXPECT_EQ(across.high, 180);
  EXPECT_EQ(along.low, 50);
  EXPECT_EQ(along.high, 120);
  EXPECT_EQ(across.CentreOf(7.0), 140.0) << "both edges show, so its size tells nothing more";
}

TEST(BoxExtent, IsCutWithinTheMarginOfEachBorderAndNotBeyond) {
  const double margin = kBorderMargin, near = margin - 0.01;
  EXPECT_FALSE(IsCut(BoxBetween(margin, margin, 640 - margin, 480 - margin), kCamera));
  EXPECT_TRUE(ExtentAcross(BoxBetween(near, 100, 90, 200), kCamera).is_low_cut);
  EXPECT_TRUE(ExtentAcross(BoxBetween(550, 100, 640 - near, 200), kCamera).is_high_cut);
  EXPECT_TRUE(ExtentAlong(BoxBetween(100, near, 200, 90), kCamera).is_low_cut);
  EXPECT_TRUE(ExtentAlong(BoxBetween(100, 400, 200, 480 - near), kCamera).is_high_cut);
}

TEST(BoxExtent, OfARoundThingIsNotFlatNearTheBorderUnlessThatCutsIt) {
  const Box flat = BoxBetween(315, 3, 563, 66), round = BoxBetween(315, 3, 388, 66);
  EXPECT_TRUE(ExtentAlong(flat, kCamera).is_low_cut);
  EXPECT_FALSE(ExtentAcross(flat, kCamera).is_cut()) << "the longer axis shows whole";
  EXPECT_FALSE(IsCut(round, kCamera));
  EXPECT_FALSE(IsCut(BoxBetween(315, 30, 563, 93), kCamera)) << "away from the border a box is";
  EXPECT_TRUE(ExtentAcross(BoxBetween(600, 100, 632, 330), kCamera).is_high_cut);
}

TEST(BoxExtent, SaysOfAHalfCutObjectWhereItsCentreIsFromTheEdgeThatShows) {
  const BoxExtent left = ExtentAcross(BoxBetween(0, 100, 60, 200), kCamera);
  EXPECT_TRUE(left.is_half_cut());
  EXPECT_EQ(left.shown_end(), 60);
  EXPECT_EQ(left.CentreOf(50.0), 10.0);
  const BoxExtent right = ExtentAcross(BoxBetween(600, 100, 640, 200), kCamera);
  EXPECT_EQ(right.shown_end(), 600);
  EXPECT_EQ(right.CentreOf(50.0), 650.0);
}

TEST(BoxExtent, CutAtBothEndsKeepsItsMiddle) {
  const BoxExtent across = ExtentAcross(BoxBetween(0, 100, 640, 200), kCamera);
  EXPECT_TRUE(across.is_cut());
  EXPECT_FALSE(across.is_half_cut());
  EXPECT_EQ(across.CentreOf(500.0), 320.0);
}

/// Clips a box to the image, as a detector does.
Box Clipped(const Box& whole) {
  return BoxBetween(std::max(whole.u - 0.5 * whole.w, 0.0), std::max(whole.v - 0.5 * whole.h, 0.0),
                    std::min<double>(whole.u + 0.5 * whole.w, kCamera.width_px),
                    std::min<double>(whole.v + 0.5 * whole.h, kCamera.height_px));
}

TEST(BoxExtent, FindsTheCentreOfWhateverTheBorderCutAtOneEnd) {
  Random random(7, "boxes");
  int cut = 0;
  for (int i = 0; i < 2000; ++i) {
    const Box whole{.u = random.Uniform(-40, 680),
                    .v = random.Uniform(-40, 520),
                    .w = random.Uniform(90, 200),
                    .h = random.Uniform(90, 200),
                    .color = "yellow"};
    const Box seen = Clipped(whole);
    const BoxExtent across = ExtentAcross(seen, kCamera), along = ExtentAlong(seen, kCamera);
    EXPECT_NEAR(across.CentreOf(0.5 * whole.w), whole.u, kBorderMargin);
    EXPECT_NEAR(along.CentreOf(0.5 * whole.h), whole.v, kBorderMargin);
    const bool loses_some = seen.w < whole.w - 1e-9 || seen.h < whole.h - 1e-9;
    EXPECT_TRUE(!loses_some || IsCut(seen, kCamera)) << "what a border took is noticed";
    cut += loses_some ? 1 : 0;
  }
  EXPECT_GT(cut, 500);
}

TEST(BoxExtent, IsTheSameRuleForAnyImageSize) {
  const CameraModel small = CameraModel::FromFieldOfView(320, 240, {.across = 1.4, .along = 1.0});
  EXPECT_TRUE(IsCut(BoxBetween(250, 50, 319, 90), small));
  EXPECT_FALSE(IsCut(BoxBetween(250, 50, 319, 90), kCamera));
}

}  // namespace
}  // namespace limpet
