// SPDX-License-Identifier: MIT
#include "training/detector/studio_things.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "limpet/objects/color_table.hpp"

namespace limpet {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

cv::Vec3f DrawThingColor(Random& random) {
  if (random.Chance(0.5)) return DrawAnyColor(random);
  const std::vector<std::string> names = ColorNames();
  return DrawPaint(names[random.Index(names.size())], random);
}

StudioSurface DrawSurface(Random& random) {
  return {.color = DrawThingColor(random),
          .clarity = static_cast<float>(random.Uniform(0.15, 1.0)),
          .mottle = static_cast<float>(random.Chance(0.5) ? random.Uniform(0.0, 0.6) : 0.0)};
}

cv::Point2f Step(const cv::Point2f& from, double length, double angle) {
  return {from.x + static_cast<float>(length * std::cos(angle)),
          from.y + static_cast<float>(length * std::sin(angle))};
}

/// A rectangle with its middle at `middle`, whose width is turned by `angle`.
std::array<cv::Point2f, 4> Rectangle(const cv::Point2f& middle, const cv::Size2d& size,
                                     double angle) {
  std::array<cv::Point2f, 4> corners;
  constexpr std::array<std::array<double, 2>, 4> kSigns{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const cv::Point2f along = Step(middle, 0.5 * size.width * kSigns.at(i)[0], angle);
    corners.at(i) = Step(along, 0.5 * size.height * kSigns.at(i)[1], angle + 0.25 * kTurn);
  }
  return corners;
}

/// Straight and long; posts stand, planks lie anyhow.
void PaintBeam(StudioCanvas& canvas, Random& random) {
  const double angle =
      random.Chance(0.5) ? 0.25 * kTurn + random.Normal(0.1) : random.Uniform(0.0, kTurn);
  const double wide = DrawLog(3.0, 70.0, random), length = DrawLog(60.0, 900.0, random);
  const auto corners = Rectangle(DrawPlace(random), {length, wide}, angle);
  PaintPolygon(canvas, corners, DrawSurface(random), random);
}

/// Pipes joined to a gate: two uprights and one or two that lie.
void PaintFrame(StudioCanvas& canvas, Random& random) {
  const cv::Point2f corner = DrawPlace(random);
  const double wide = DrawLog(40.0, 400.0, random);
  const double high = DrawLog(40.0, 300.0, random);
  const double lean = random.Normal(0.08);
  const cv::Point2f right = Step(corner, wide, lean);
  const double up = lean + 0.25 * kTurn;
  const std::array points{Step(corner, -high, up), corner, right, Step(right, -high, up)};
  const StudioSurface surface = DrawSurface(random);
  PaintStroke(canvas, points, DrawLog(2.0, 22.0, random), surface, random);
}

void PaintRope(StudioCanvas& canvas, Random& random) {
  std::vector<cv::Point2f> points{DrawPlace(random)};
  double angle = random.Uniform(0.0, kTurn);
  const double step = random.Uniform(8.0, 30.0);
  for (int i = 0; i < 30; ++i) {
    angle += random.Normal(0.2);
    points.push_back(Step(points.back(), step, angle));
  }
  const StudioSurface surface = DrawSurface(random);
  PaintStroke(canvas, points, DrawLog(1.0, 8.0, random), surface, random);
}

/// Something with three to six straight sides: flag, tag, board, cone.
void PaintPlate(StudioCanvas& canvas, Random& random) {
  const cv::Point2f middle = DrawPlace(random);
  const double size = DrawLog(8.0, 110.0, random);
  const auto sides = 3 + static_cast<int>(random.Index(3));
  const double first = random.Uniform(0.0, kTurn);
  std::vector<cv::Point2f> corners;
  for (int i = 0; i < sides; ++i) {
    const double angle = first + kTurn * (i + random.Uniform(-0.2, 0.2)) / sides;
    corners.push_back(Step(middle, size * random.Uniform(0.7, 1.3), angle));
  }
  PaintPolygon(canvas, corners, DrawSurface(random), random);
}

/// An outline whose radius wanders: stone, sponge, weed; the more octaves the more torn.
void PaintLump(StudioCanvas& canvas, Random& random) {
  const cv::Point2f middle = DrawPlace(random);
  const double size = DrawLog(6.0, 140.0, random);
  const double flat = random.Uniform(0.4, 1.0);
  const double tilt = random.Uniform(0.0, kTurn);
  const double torn = random.Uniform(0.18, 0.6);
  std::array<double, 8> waves{};
  std::array<double, 8> phases{};
  for (std::size_t i = 0; i < waves.size(); ++i) {
    waves.at(i) = random.Normal(torn / std::sqrt(1.0 + static_cast<double>(i)));
    phases.at(i) = random.Uniform(0.0, kTurn);
  }
  std::vector<cv::Point2f> corners;
  for (int i = 0; i < 64; ++i) {
    const double angle = kTurn * i / 64;
    double radius = 1.0;
    for (std::size_t k = 0; k < waves.size(); ++k)
      radius += waves.at(k) * std::cos((static_cast<double>(k) + 2.0) * angle + phases.at(k));
    radius = size * std::max(0.15, radius);
    const cv::Point2f long_way = Step(middle, radius * std::cos(angle), tilt);
    corners.push_back(Step(long_way, flat * radius * std::sin(angle), tilt + 0.25 * kTurn));
  }
  StudioSurface surface = DrawSurface(random);
  if (random.Chance(0.6)) surface.color = DrawAnyColor(random);
  PaintPolygon(canvas, corners, surface, random);
}

void PaintStarfish(StudioCanvas& canvas, Random& random) {
  const cv::Point2f middle = DrawPlace(random);
  const double size = DrawLog(8.0, 60.0, random);
  const double inner = size * random.Uniform(0.25, 0.5);
  const double first = random.Uniform(0.0, kTurn);
  std::vector<cv::Point2f> corners;
  for (int i = 0; i < 10; ++i)
    corners.push_back(Step(middle, i % 2 == 0 ? size : inner, first + kTurn * i / 10));
  PaintPolygon(canvas, corners, DrawSurface(random), random);
}

/// Clearly longer than wide: a can, a bottle, a fender.
void PaintCapsule(StudioCanvas& canvas, Random& random) {
  const cv::Point2f from = DrawPlace(random);
  const double width = DrawLog(8.0, 80.0, random);
  const double angle = random.Uniform(0.0, kTurn);
  const std::array ends{from, Step(from, width * random.Uniform(0.9, 3.0), angle)};
  if (random.Chance(0.5)) {
    PaintStroke(canvas, ends, width, DrawSurface(random), random);
  } else {
    const cv::Point2f middle = 0.5F * (ends[0] + ends[1]);
    const StudioSurface surface = DrawSurface(random);
    const double length = width * random.Uniform(1.3, 3.0);
    PaintPolygon(canvas, Rectangle(middle, {length, width}, angle), surface, random);
  }
}

/// Half as long again as wide or more: a fish, a buoy of another make, a bowl from the side.
void PaintOval(StudioCanvas& canvas, Random& random) {
  const cv::Point2f middle = DrawPlace(random);
  const double along = DrawLog(10.0, 120.0, random);
  const double across = along / random.Uniform(1.5, 3.0);
  const double tilt = random.Uniform(0.0, kTurn);
  std::vector<cv::Point2f> corners;
  for (int i = 0; i < 48; ++i) {
    const double angle = kTurn * i / 48;
    const cv::Point2f long_way = Step(middle, along * std::cos(angle), tilt);
    corners.push_back(Step(long_way, across * std::sin(angle), tilt + 0.25 * kTurn));
  }
  PaintPolygon(canvas, corners, DrawSurface(random), random);
}

/// A tyre, a ring, or a part of one.
void PaintRing(StudioCanvas& canvas, Random& random) {
  const cv::Point2f middle = DrawPlace(random);
  const double size = DrawLog(10.0, 120.0, random);
  const double flat = random.Uniform(0.3, 1.0);
  const double tilt = random.Uniform(0.0, kTurn);
  const double share = random.Chance(0.5) ? 1.0 : random.Uniform(0.3, 0.9);
  std::vector<cv::Point2f> points;
  for (int i = 0; i <= 48; ++i) {
    const double angle = share * kTurn * i / 48;
    const cv::Point2f long_way = Step(middle, size * std::cos(angle), tilt);
    points.push_back(Step(long_way, flat * size * std::sin(angle), tilt + 0.25 * kTurn));
  }
  const StudioSurface surface = DrawSurface(random);
  PaintStroke(canvas, points, size * random.Uniform(0.1, 0.5), surface, random);
}

/// Light without an outline: a lamp, the sun's reflection, something out of focus.
void PaintGlow(StudioCanvas& canvas, Random& random) {
  const cv::Point2f middle = DrawPlace(random);
  const double size = DrawLog(6.0, 90.0, random);
  const double flat = random.Uniform(0.4, 1.0);
  const auto strength = static_cast<float>(random.Uniform(0.2, 2.0));
  const cv::Vec3f color = strength * DrawThingColor(random);
  const int reach = cvCeil(2.5 * size);
  const cv::Rect area =
      cv::Rect(cvRound(middle.x) - reach, cvRound(middle.y) - reach, 2 * reach, 2 * reach) &
      cv::Rect(0, 0, StudioCanvas::kWidth, StudioCanvas::kHeight);
  for (int row = area.y; row < area.y + area.height; ++row) {
    for (int column = area.x; column < area.x + area.width; ++column) {
      const double across = (column - static_cast<double>(middle.x)) / size;
      const double down = (row - static_cast<double>(middle.y)) / (flat * size);
      canvas.light(row, column) +=
          static_cast<float>(std::exp(-0.5 * (across * across + down * down))) * color;
    }
  }
}

/// What drifts by: points and short streaks.
void PaintFlakes(StudioCanvas& canvas, Random& random) {
  const double streak = random.Chance(0.4) ? random.Uniform(2.0, 20.0) : 0.5;
  const double angle = random.Uniform(0.0, kTurn);
  for (std::uint64_t i = random.Index(80); i > 0; --i) {
    const cv::Point2f from = DrawPlace(random);
    const double turned = angle + random.Normal(0.3);
    const std::array ends{from, Step(from, streak * random.Uniform(0.5, 1.5), turned)};
    const StudioSurface flake{.color = {0.8F, 0.9F, 0.9F},
                              .clarity = static_cast<float>(random.Uniform(0.1, 1.0))};
    PaintStroke(canvas, ends, DrawLog(1.0, 5.0, random), flake, random);
  }
}

}  // namespace

void PaintThing(StudioCanvas& canvas, Random& random) {
  using Painter = void (*)(StudioCanvas&, Random&);
  constexpr std::array<Painter, 13> kPainters{
      PaintBeam,    PaintBeam, PaintFrame, PaintRope,   PaintPlate, PaintLump, PaintStarfish,
      PaintCapsule, PaintRing, PaintGlow,  PaintFlakes, PaintLump,  PaintOval};
  kPainters.at(random.Index(kPainters.size()))(canvas, random);
}

}  // namespace limpet
