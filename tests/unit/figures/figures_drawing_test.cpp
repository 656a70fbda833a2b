// SPDX-License-Identifier: MIT
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "limpet/figures/map_axes.hpp"
#include "limpet/figures/rgba_png.hpp"
#include "limpet/figures/svg_canvas.hpp"
#include "limpet/figures/tick_marks.hpp"

namespace limpet {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

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
  EXPECT_THAT(TickMarks({-7.0, 12.0}, 5), ElementsAre(-5.0, 0.0, 5.0, 10.0));
}

TEST(TickMarks, AreNoneOnAnEmptyRange) { EXPECT_TRUE(TickMarks({1.0, 1.0}, 5).empty()); }

TEST(TickText, HasATrueMinusAndNoNegativeZero) {
  EXPECT_EQ(TickText(-2.5), "\u22122.5");
  EXPECT_EQ(TickText(-0.0), "0");
}

TEST(SvgCanvas, EscapesText) {
  SvgCanvas canvas({10.0, 10.0}, "a < b");
  canvas.Text({0.0, 0.0}, "\"x\" & y");
  EXPECT_THAT(canvas.Finish(), HasSubstr("&quot;x&quot; &amp; y"));
  EXPECT_THAT(canvas.Finish(), HasSubstr("<title>a &lt; b</title>"));
}

TEST(SvgCanvas, KeepsClipsOfTwoPicturesApart) {
  const auto clip_of = [](const char* title) {
    SvgCanvas canvas({10.0, 10.0}, title);
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
  const SvgCanvas::Point origin = map.At({0.0, 0.0});
  EXPECT_NEAR((map.At({1.0, 0.0}) - origin).norm(), (map.At({0.0, 1.0}) - origin).norm(), 1e-12);
}

TEST(MapAxes, HasNorthUpAndEastRight) {
  const MapAxes map({-15.0, 15.0, -18.0, 18.0, 2.0, 2.0}, "t", "s");
  EXPECT_LT(map.At({1.0, 0.0}).y(), map.At({0.0, 0.0}).y());
  EXPECT_GT(map.At({0.0, 1.0}).x(), map.At({0.0, 0.0}).x());
}

}  // namespace
}  // namespace limpet
