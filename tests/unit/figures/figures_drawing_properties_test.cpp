// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/figures/map_axes.hpp"
#include "limpet/figures/palette.hpp"
#include "limpet/figures/plot_axes.hpp"
#include "limpet/figures/probability_text.hpp"
#include "limpet/figures/rgba_png.hpp"
#include "limpet/figures/tick_marks.hpp"
#include "tests/unit/figures/svg_reader.hpp"

namespace limpet {
namespace {

TEST(TickMarksProperties, AreRoundEvenlySpacedInsideAndNotTooMany) {
  Random random(1, "ticks");
  for (int run = 0; run < 2000; ++run) {
    const double size = std::pow(10.0, random.Uniform(-3.0, 5.0));
    const double low = random.Uniform(-1.0, 1.0) * size;
    const double high = low + random.Uniform(0.01, 2.0) * size;
    const int count = 2 + static_cast<int>(random.Index(10));
    const std::vector<double> ticks = TickMarks({low, high}, count);
    EXPECT_LE(ticks.size(), static_cast<std::size_t>(count) + 1);
    const double slack = 1e-8 * (std::abs(low) + std::abs(high));
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      EXPECT_GE(ticks[i], low - slack);
      EXPECT_LE(ticks[i], high + slack);
      if (i < 2) continue;
      const double step = ticks[1] - ticks[0];
      EXPECT_NEAR(ticks[i] - ticks[i - 1], step, 1e-9 * size);
      const double digit = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
      EXPECT_TRUE(std::abs(digit - 1.0) < 1e-6 || std::abs(digit - 2.0) < 1e-6 ||
                  std::abs(digit - 5.0) < 1e-6)
          << step;
    }
  }
}

TEST(TickMarksProperties, AreAtLeastAThirdOfWhatWasAskedFor) {
  Random random(2, "ticks");
  for (int run = 0; run < 1000; ++run) {
    const double low = random.Uniform(-100.0, 100.0), high = low + random.Uniform(0.1, 500.0);
    EXPECT_GE(TickMarks({low, high}, 9).size(), 3U) << low << " " << high;
  }
}

double DistanceToLine(const SvgCanvas::Point& p, const std::vector<SvgCanvas::Point>& line) {
  double least = 1e9;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const SvgCanvas::Point along = line[i] - line[i - 1];
    const double square = along.squaredNorm();
    const double share =
        square > 0.0 ? std::clamp((p - line[i - 1]).dot(along) / square, 0.0, 1.0) : 0.0;
    least = std::min(least, (p - line[i - 1] - share * along).norm());
  }
  return least;
}

TEST(SimplifiedCurves, StayWithinTheToleranceOfEveryPoint) {
  Random random(3, "curves");
  for (int run = 0; run < 100; ++run) {
    std::vector<SvgCanvas::Point> points{{0.0, 0.0}};
    for (std::uint64_t i = 2 + random.Index(200); i > 0; --i) {
      const SvgCanvas::Point step(random.Uniform(-1.0, 2.0), random.Uniform(-1.0, 1.0));
      points.emplace_back(points.back() + step);
    }
    const double tolerance = random.Uniform(0.05, 2.0);
    const std::vector<SvgCanvas::Point> few = Simplified(points, tolerance);
    EXPECT_EQ(few.front(), points.front());
    EXPECT_EQ(few.back(), points.back());
    auto next = points.begin();
    for (const SvgCanvas::Point& kept : few) {  // in order, and none that was not there
      next = std::find(next, points.end(), kept);
      ASSERT_NE(next, points.end());
    }
    for (const SvgCanvas::Point& point : points) {
      EXPECT_LE(DistanceToLine(point, few), tolerance + 1e-9);
    }
  }
}

TEST(SimplifiedCurves, OfAStraightLineAreItsTwoEnds) {
  std::vector<SvgCanvas::Point> points;
  for (int i = 0; i < 5000; ++i)
    points.emplace_back(0.1 * i, 0.05 * i);
  EXPECT_EQ(Simplified(points, 0.01).size(), 2U);
}

TEST(PlotAxesProperties, PutTheCornersOfTheRangesInTheCornersOfTheFrame) {
  SvgCanvas canvas({700.0, 500.0}, "plot");
  PlotAxes::Layout layout;
  layout.corner = {50.0, 40.0};
  layout.size = {600.0, 300.0};
  layout.x = {10.0, 20.0};
  layout.y = {-1.0, 3.0};
  const PlotAxes plot(canvas, layout);
  EXPECT_LT((plot.At({10.0, 3.0}) - SvgCanvas::Point(50.0, 40.0)).norm(), 1e-9);
  EXPECT_LT((plot.At({20.0, -1.0}) - SvgCanvas::Point(650.0, 340.0)).norm(), 1e-9);
  EXPECT_LT((plot.At({15.0, 1.0}) - SvgCanvas::Point(350.0, 190.0)).norm(), 1e-9);
}

TEST(PlotAxesProperties, CutACurveToTheFrame) {
  SvgCanvas canvas({700.0, 500.0}, "plot");
  PlotAxes plot(canvas, {.x = {0.0, 1.0}, .y = {0.0, 1.0}, .x_label = "way", .y_label = "share"});
  plot.Curve({0.0, 0.5, 1.0}, {-5.0, 0.5, 9.0}, {.stroke = palette::kBlue});
  const auto elements = ReadSvg(canvas.Finish());
  const auto clip = std::ranges::find(elements, "g", &SvgElement::name);
  ASSERT_NE(clip, elements.end());
  EXPECT_TRUE(clip->attributes.contains("clip-path"));
  for (const char* label : {"way", "share"}) {
    EXPECT_EQ(std::ranges::count(elements, label, &SvgElement::text), 1) << label;
  }
}

TEST(MapAxesProperties, HoldAreaAndMarginWhateverTheirShape) {
  Random random(4, "maps");
  for (int run = 0; run < 100; ++run) {
    SurveyArea area;
    area.north_min = random.Uniform(-500.0, 500.0);
    area.north_max = area.north_min + random.Uniform(1.0, 400.0);
    area.east_min = random.Uniform(-500.0, 500.0);
    area.east_max = area.east_min + random.Uniform(1.0, 400.0);
    const MapAxes map(area, "t", "s");
    const SvgElement picture = ReadSvg(map.Finish()).at(0);
    for (const double north : {area.north_min - area.margin, area.north_max + area.margin}) {
      for (const double east : {area.east_min - area.margin, area.east_max + area.margin}) {
        const SvgCanvas::Point at = map.At({north, east});
        EXPECT_GE(at.minCoeff(), 0.0);
        EXPECT_LE(at.x(), picture.Number("width"));
        EXPECT_LE(at.y(), picture.Number("height"));
      }
    }
    EXPECT_GT(picture.Number("width") - map.right(), 150.0) << "room for the legend";
  }
}

TEST(Base64Properties, IsUndoneByItsTable) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  Random random(5, "base64");
  for (std::size_t size = 0; size < 60; ++size) {
    std::vector<std::uint8_t> bytes, back;
    for (std::size_t i = 0; i < size; ++i) {
      bytes.push_back(static_cast<std::uint8_t>(random.Index(256)));
    }
    const std::string text = Base64(bytes);
    EXPECT_EQ(text.size() % 4, 0U);
    std::uint32_t bits = 0;
    int held = 0;
    for (const char letter : text) {
      if (letter == '=') break;
      bits = (bits << 6U) | static_cast<std::uint32_t>(letters.find(letter));
      held += 6;
      if (held >= 8) {
        held -= 8;
        back.push_back(static_cast<std::uint8_t>((bits >> static_cast<unsigned>(held)) & 0xffU));
      }
    }
    EXPECT_EQ(back, bytes);
  }
}

double LuminanceOf(const palette::Rgb& rgb) {
  return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

TEST(Palettes, GrowLighterOrDarkerAllTheWaySoThatTheyReadInGrey) {
  for (double share = 0.02; share <= 1.0; share += 0.02) {
    EXPECT_GT(LuminanceOf(palette::Viridis(share)), LuminanceOf(palette::Viridis(share - 0.02)));
    EXPECT_LE(LuminanceOf(palette::Coverage(share)), LuminanceOf(palette::Coverage(share - 0.02)));
  }
  EXPECT_EQ(palette::Viridis(-1.0), palette::Viridis(0.0));
  EXPECT_EQ(palette::Viridis(2.0), palette::Viridis(1.0));
}

TEST(ProbabilityTexts, NeverSayThatSomethingIsCertain) {
  for (double p = 0.0; p <= 1.0; p += 0.0001) {
    const std::string text = ProbabilityText(p);
    EXPECT_NE(text, "0.000");
    EXPECT_NE(text, "1.000");
  }
  EXPECT_EQ(ProbabilityText(1.0), ">0.999");
  EXPECT_EQ(ProbabilityText(0.0), "<0.001");
  EXPECT_EQ(ProbabilityText(0.5), "0.500");
  EXPECT_EQ(MetresText({}), "unknown");
}

}  // namespace
}  // namespace limpet
