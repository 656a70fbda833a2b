// SPDX-License-Identifier: MIT
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "limpet/core/random.hpp"
#include "limpet/figures/map_axes.hpp"
#include "limpet/figures/rgba_png.hpp"
#include "limpet/figures/svg_canvas.hpp"
#include "limpet/figures/tick_marks.hpp"
#include "limpet/scoring/disc_in_rectangle.hpp"

namespace limpet {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(DiscInRectangle, IsWholeInTheMiddle) {
  EXPECT_EQ(ShareOfDiscInRectangle(0.0, 0.0, 0.5, 2.0, 1.0), 1.0);
}

TEST(DiscInRectangle, IsHalfOnAnEdge) {
  EXPECT_NEAR(ShareOfDiscInRectangle(2.0, 0.0, 0.5, 2.0, 1.0), 0.5, 1e-12);
}

TEST(DiscInRectangle, IsAQuarterOnACorner) {
  EXPECT_NEAR(ShareOfDiscInRectangle(-2.0, 1.0, 0.5, 2.0, 1.0), 0.25, 1e-12);
}

TEST(DiscInRectangle, IsTheRectanglesShareWhenTheDiscIsTheLarger) {
  EXPECT_NEAR(ShareOfDiscInRectangle(0.3, -0.2, 10.0, 2.0, 1.0), 8.0 / (100.0 * 3.14159265358979),
              1e-9);
}

TEST(DiscInRectangle, AgreesWithCountingPointsAnywhere) {
  Random random(7);
  for (int trial = 0; trial < 20; ++trial) {
    const double x = random.Uniform(-2.0, 2.0), y = random.Uniform(-2.0, 2.0);
    int inside = 0, points = 0;
    for (double a = -0.995; a < 1.0; a += 0.01) {
      for (double b = -0.995; b < 1.0; b += 0.01) {
        if (a * a + b * b > 1.0) continue;
        ++points;
        inside += std::abs(x + a) <= 1.3 && std::abs(y + b) <= 0.7 ? 1 : 0;
      }
    }
    EXPECT_NEAR(ShareOfDiscInRectangle(x, y, 1.0, 1.3, 0.7), static_cast<double>(inside) / points,
                0.01);
  }
}

TEST(Base64, EncodesTheStandardsExamples) {
  const auto encoded = [](std::string_view text) {
    return Base64(std::vector<std::uint8_t>(text.begin(), text.end()));
  };
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
}

TEST(RgbaPng, EndsWithTheChecksumThatEveryPngEndsWith) {
  const auto png = EncodePng({1, 1, {{1, 2, 3, 255}}});
  const std::vector<std::uint8_t> end(png.end() - 8, png.end());
  EXPECT_THAT(end, ElementsAre('I', 'E', 'N', 'D', 0xae, 0x42, 0x60, 0x82));
}

TEST(RgbaPng, KeepsEveryColourAndItsOpacity) {
  const auto png = EncodePng({2, 1, {{1, 2, 3, 255}, {200, 100, 50, 0}}});
  const cv::Mat image = cv::imdecode(png, cv::IMREAD_UNCHANGED);
  ASSERT_EQ(image.cols, 2);
  EXPECT_EQ(image.at<cv::Vec4b>(0, 0), cv::Vec4b(3, 2, 1, 255));
  EXPECT_EQ(image.at<cv::Vec4b>(0, 1), cv::Vec4b(50, 100, 200, 0));
}

TEST(RgbaPng, IsSmallForAnEvenImage) {
  const auto png = EncodePng({400, 400, std::vector<RgbaImage::Pixel>(160000)});
  EXPECT_LT(png.size(), 2000U);
}

TEST(TickMarks, AreRound) {
  EXPECT_THAT(TickMarks(-7.0, 12.0, 5), ElementsAre(-5.0, 0.0, 5.0, 10.0));
}

TEST(TickMarks, AreNoneOnAnEmptyRange) { EXPECT_TRUE(TickMarks(1.0, 1.0, 5).empty()); }

TEST(TickText, HasATrueMinusAndNoNegativeZero) {
  EXPECT_EQ(TickText(-2.5), "\u22122.5");
  EXPECT_EQ(TickText(-0.0), "0");
}

TEST(SvgCanvas, EscapesText) {
  SvgCanvas canvas(10.0, 10.0, "a < b");
  canvas.Text({0.0, 0.0}, "\"x\" & y");
  EXPECT_THAT(canvas.Finish(), HasSubstr("&quot;x&quot; &amp; y"));
  EXPECT_THAT(canvas.Finish(), HasSubstr("<title>a &lt; b</title>"));
}

TEST(SvgCanvas, KeepsClipsOfTwoPicturesApart) {
  const auto clip_of = [](const char* title) {
    SvgCanvas canvas(10.0, 10.0, title);
    canvas.BeginClip({0.0, 0.0}, {5.0, 5.0});
    canvas.EndClip();
    const std::string text = canvas.Finish();
    return text.substr(text.find("clipPath id="), 22);
  };
  EXPECT_NE(clip_of("one"), clip_of("two"));
}

TEST(Simplified, KeepsEndsAndCornersOnly) {
  const std::vector<SvgCanvas::Point> points{
      {0.0, 0.0}, {1.0, 0.01}, {2.0, 0.0}, {2.0, 1.0}, {2.0, 2.0}};
  EXPECT_EQ(Simplified(points, 0.1).size(), 3U);
}

TEST(MapAxes, HasTheSameScaleBothWays) {
  const MapAxes map({-15.0, 15.0, -18.0, 18.0, 2.0, 2.0}, "t", "s");
  const SvgCanvas::Point origin = map.At(0.0, 0.0);
  EXPECT_NEAR((map.At(1.0, 0.0) - origin).norm(), (map.At(0.0, 1.0) - origin).norm(), 1e-12);
}

TEST(MapAxes, HasNorthUpAndEastRight) {
  const MapAxes map({-15.0, 15.0, -18.0, 18.0, 2.0, 2.0}, "t", "s");
  EXPECT_LT(map.At(1.0, 0.0).y(), map.At(0.0, 0.0).y());
  EXPECT_GT(map.At(0.0, 1.0).x(), map.At(0.0, 0.0).x());
}

}  // namespace
}  // namespace limpet
