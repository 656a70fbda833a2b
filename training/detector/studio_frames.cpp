// SPDX-License-Identifier: MIT
#include "training/detector/studio_frames.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "limpet/core/random.hpp"

#include "training/detector/studio_backdrop.hpp"
#include "training/detector/studio_ball.hpp"
#include "training/detector/studio_camera.hpp"
#include "training/detector/studio_things.hpp"

namespace limpet {
namespace {

const cv::Rect2d kCanvas(0.0, 0.0, StudioCanvas::kWidth, StudioCanvas::kHeight);

/// Share of the ball's pixels that `after` shows as `before` does.
double ShareKept(const StudioBall& ball, const cv::Mat3f& before, const cv::Mat3f& after) {
  const cv::Rect2d area = ball.Outline() & kCanvas;
  int inside = 0;
  int kept = 0;
  for (int row = static_cast<int>(area.y); row < static_cast<int>(area.br().y); ++row) {
    for (int column = static_cast<int>(area.x); column < static_cast<int>(area.br().x); ++column) {
      if (ball.ScaleAt({column + 0.5, row + 0.5}) > 1.0) continue;
      ++inside;
      kept += cv::norm(before(row, column) - after(row, column)) < 0.02 ? 1 : 0;
    }
  }
  return inside > 0 ? static_cast<double>(kept) / inside : 0.0;
}

BallLabel LabelOf(const StudioBall& ball, double share_kept) {
  const cv::Rect2d outline = ball.Outline();
  const cv::Rect2d seen = outline & kCanvas;
  BallLabel label;
  label.box = {.u = seen.x + 0.5 * seen.width,
               .v = seen.y + 0.5 * seen.height,
               .w = seen.width,
               .h = seen.height,
               .confidence = 1.0,
               .color = ball.color};
  label.is_hidden = share_kept < 0.5 || seen.area() < 0.35 * outline.area();
  return label;
}

/// Balls that do not hide each other.
std::vector<StudioBall> DrawBalls(Random& random) {
  std::vector<StudioBall> balls;
  const std::uint64_t wanted = random.Chance(0.3) ? 0 : 1 + random.Index(5);
  for (std::uint64_t i = 0; i < wanted; ++i) {
    const StudioBall ball = DrawBall(random);
    const bool meets = std::ranges::any_of(balls, [&ball](const StudioBall& other) {
      return !(other.Outline() & ball.Outline()).empty();
    });
    if (!meets && !(ball.Outline() & kCanvas).empty()) balls.push_back(ball);
  }
  return balls;
}

}  // namespace

LabelledPicture StudioFrame(std::uint64_t seed) {
  Random random(seed, "studio frame");
  StudioCanvas canvas = DrawBackdrop(random);
  const std::uint64_t most_things = random.Chance(0.25) ? 36 : 12;
  for (std::uint64_t i = random.Index(most_things); i > 0; --i)
    PaintThing(canvas, random);
  const std::vector<StudioBall> balls = DrawBalls(random);
  for (const StudioBall& ball : balls)
    PaintBall(canvas, ball, random);
  // Posts of one ball may stand before another, and some things before all of them.
  const cv::Mat3f before = canvas.light.clone();
  if (random.Chance(0.25)) PaintThing(canvas, random);
  LabelledPicture picture;
  for (const StudioBall& ball : balls)
    picture.labels.push_back(LabelOf(ball, ShareKept(ball, before, canvas.light)));
  picture.pixels = TakePicture(std::move(canvas), random);
  MarkUnclear(picture);
  return picture;
}

}  // namespace limpet
