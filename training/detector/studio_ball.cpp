// SPDX-License-Identifier: MIT
#include "training/detector/studio_ball.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace limpet {
namespace {

/// The half axes of the outline's upright rectangle.
cv::Point2d HalfSize(const StudioBall& ball) {
  const double along = ball.radius * ball.stretch;
  const double across = ball.radius;
  return {std::hypot(along * std::cos(ball.tilt), across * std::sin(ball.tilt)),
          std::hypot(along * std::sin(ball.tilt), across * std::cos(ball.tilt))};
}

struct BallLook {
  cv::Vec3f paint;
  cv::Vec3f band;
  float clarity;
  float ambient;
  float gloss;
  float hardness;
  float mottle;
  bool has_band;
  double band_tilt;
  cv::Vec3f light;  ///< unit vector towards it: right, down, towards the lens
};

BallLook DrawLook(const StudioCanvas& canvas, const StudioBall& ball, Random& random) {
  BallLook look;
  look.paint = DrawPaint(ball.color, random);
  look.band = DrawAnyColor(random);
  look.clarity =
      static_cast<float>(random.Chance(0.65) ? random.Uniform(0.5, 1.0) : random.Uniform(0.2, 0.6));
  look.ambient = static_cast<float>(random.Uniform(0.15, 0.95));
  look.gloss = static_cast<float>(random.Chance(0.35) ? random.Uniform(0.05, 0.8) : 0.0);
  look.hardness = static_cast<float>(DrawLog(4.0, 60.0, random));
  look.mottle = static_cast<float>(random.Chance(0.4) ? random.Uniform(0.0, 0.4) : 0.0);
  look.has_band = random.Chance(0.08);
  look.band_tilt = random.Uniform(0.0, std::numbers::pi);
  const auto towards_lens = static_cast<float>(random.Uniform(-0.2, 1.2));
  look.light = {canvas.towards_light[0], canvas.towards_light[1], towards_lens};
  look.light /= static_cast<float>(cv::norm(look.light));
  return look;
}

/// What the surface with unit normal `n` returns, before water.
cv::Vec3f ShadeOf(const BallLook& look, const cv::Vec3f& n, float texture) {
  const float facing = std::max(0.0F, n.dot(look.light));
  const float level = (look.ambient + (1.0F - look.ambient) * facing) *
                      std::max(0.1F, 1.0F + look.mottle * texture);
  const double along = n[0] * std::sin(look.band_tilt) + n[1] * std::cos(look.band_tilt);
  const cv::Vec3f& paint = look.has_band && std::abs(along) < 0.22 ? look.band : look.paint;
  cv::Vec3f half = look.light + cv::Vec3f(0.0F, 0.0F, 1.0F);
  half /= static_cast<float>(cv::norm(half));
  const float glint = look.gloss * std::pow(std::max(0.0F, n.dot(half)), look.hardness);
  return level * paint + cv::Vec3f(glint, glint, glint);
}

void PaintMooring(StudioCanvas& canvas, const StudioBall& ball, Random& random) {
  const StudioSurface surface{.color = DrawAnyColor(random),
                              .clarity = static_cast<float>(random.Uniform(0.3, 1.0))};
  const float way = random.Chance(0.9) ? 1.0F : -1.0F;  // a rope may hold it from above
  const auto lean = static_cast<float>(random.Normal(0.12));
  const auto radius = static_cast<float>(ball.radius);
  const cv::Point2f foot = ball.middle + cv::Point2f(lean * 600.0F, way * 600.0F);
  const double width = ball.radius * DrawLog(0.05, 0.4, random);
  PaintStroke(canvas, std::array{ball.middle, foot}, width, surface, random);
  if (random.Chance(0.4)) {  // a collar where post and ball meet
    const auto wide = radius * static_cast<float>(random.Uniform(0.25, 0.7));
    const auto long_way = radius * static_cast<float>(random.Uniform(0.3, 1.2));
    const cv::Point2f top = ball.middle + cv::Point2f(0.0F, way * 0.8F * radius);
    const cv::Point2f end = top + cv::Point2f(lean * long_way, way * long_way);
    const std::array corners{top + cv::Point2f(-wide, 0.0F), top + cv::Point2f(wide, 0.0F),
                             end + cv::Point2f(0.3F * wide, 0.0F),
                             end + cv::Point2f(-0.3F * wide, 0.0F)};
    PaintPolygon(canvas, corners, surface, random);
  }
}

}  // namespace

double StudioBall::ScaleAt(const cv::Point2d& at_px) const {
  const double du = at_px.x - static_cast<double>(middle.x);
  const double dv = at_px.y - static_cast<double>(middle.y);
  const double along = (du * std::cos(tilt) + dv * std::sin(tilt)) / (radius * stretch);
  const double across = (-du * std::sin(tilt) + dv * std::cos(tilt)) / radius;
  return std::hypot(along, across);
}

cv::Rect2d StudioBall::Outline() const {
  const cv::Point2d half = HalfSize(*this);
  return {static_cast<double>(middle.x) - half.x, static_cast<double>(middle.y) - half.y,
          2.0 * half.x, 2.0 * half.y};
}

StudioBall DrawBall(Random& random) {
  // What buoys are painted with mostly comes more often.
  constexpr std::array kColors{"yellow", "yellow", "yellow", "orange", "orange", "orange",
                               "green",  "green",  "green",  "red",    "red",    "white",
                               "white",  "blue",   "black",  "purple"};
  StudioBall ball;
  ball.color = kColors.at(random.Index(kColors.size()));
  ball.radius = DrawLog(8.0, 130.0, random);
  ball.middle = DrawPlace(random);
  ball.stretch = random.Chance(0.5) ? 1.0 : random.Uniform(1.0, 1.18);
  ball.tilt = random.Uniform(0.0, std::numbers::pi);
  return ball;
}

void PaintBall(StudioCanvas& canvas, const StudioBall& ball, Random& random) {
  if (random.Chance(0.5)) PaintMooring(canvas, ball, random);
  const BallLook look = DrawLook(canvas, ball, random);
  const double cells = DrawLog(8.0, 60.0, random);
  const cv::Mat1f texture =
      look.mottle > 0.0F ? DrawNoise({cells, cells, 2, 0.7}, random) : cv::Mat1f();
  const cv::Rect2d outline = ball.Outline();
  const cv::Rect area = cv::Rect(cvFloor(outline.x) - 1, cvFloor(outline.y) - 1,
                                 cvCeil(outline.width) + 3, cvCeil(outline.height) + 3) &
                        cv::Rect(0, 0, StudioCanvas::kWidth, StudioCanvas::kHeight);
  for (int row = area.y; row < area.y + area.height; ++row) {
    for (int column = area.x; column < area.x + area.width; ++column) {
      const double scale = ball.ScaleAt({column + 0.5, row + 0.5});
      const auto cover =
          static_cast<float>(std::clamp((1.0 - scale) * ball.radius + 0.5, 0.0, 1.0));
      if (cover <= 0.0F) continue;
      const auto right =
          static_cast<float>((column + 0.5 - static_cast<double>(ball.middle.x)) / ball.radius);
      const auto down =
          static_cast<float>((row + 0.5 - static_cast<double>(ball.middle.y)) / ball.radius);
      const float rest =
          std::sqrt(std::max(0.0F, 1.0F - std::min(1.0F, right * right + down * down)));
      const float grain = texture.empty() ? 0.0F : texture(row, column);
      const cv::Vec3f seen =
          look.clarity * canvas.brightness * ShadeOf(look, {right, down, rest}, grain) +
          (1.0F - look.clarity) * canvas.water;
      cv::Vec3f& pixel = canvas.light(row, column);
      pixel += cover * (seen - pixel);
    }
  }
}

}  // namespace limpet
