// SPDX-License-Identifier: MIT
#include "limpet/replay_output/replay_plot.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limpet/figures/chart_layout.hpp"
#include "limpet/figures/map_axes.hpp"
#include "limpet/figures/map_symbols.hpp"
#include "limpet/figures/palette.hpp"
#include "limpet/figures/plot_axes.hpp"

namespace limpet {
namespace {

using Point = SvgCanvas::Point;

constexpr Paint kOnline{.stroke = palette::kBlue, .width = 1.3};
constexpr Paint kDeadReckoning{.stroke = palette::kVermillion, .width = 1.4, .dash = "6 4"};
constexpr Paint kTrack{.stroke = palette::kMapInk, .width = 1.5};
constexpr Paint kEllipse{.fill = palette::kOrange, .stroke = palette::kVermillion, .opacity = 0.35};

/// Places in the smoothed track, for times that ascend.
class SmoothedTrack {
 public:
  explicit SmoothedTrack(const std::vector<SmoothedPose>& poses) : poses_(poses) {}
  [[nodiscard]] Eigen::Vector3d At(double t) {
    while (next_ + 1 < poses_.size() && poses_[next_].t < t)
      ++next_;
    if (next_ == 0) return poses_.front().X_WB.p_WB;
    const SmoothedPose &a = poses_[next_ - 1], &b = poses_[next_];
    const double share = std::clamp((t - a.t) / (b.t - a.t), 0.0, 1.0);
    return a.X_WB.p_WB + share * (b.X_WB.p_WB - a.X_WB.p_WB);
  }

 private:
  const std::vector<SmoothedPose>& poses_;
  std::size_t next_ = 0;
};

/// Differences of poses from the smoothed track, per axis, over minutes.
struct Differences {
  std::vector<double> minutes;
  std::vector<double> axis[3];
};

Differences DifferencesOf(const std::vector<SmoothedPose>& poses, const ReplayResult& result) {
  SmoothedTrack smoothed(result.smoothed);
  Differences out;
  for (const SmoothedPose& pose : poses) {
    const Eigen::Vector3d off = pose.X_WB.p_WB - smoothed.At(pose.t);
    out.minutes.push_back(pose.t / 60.0);
    for (int i = 0; i < 3; ++i)
      out.axis[i].push_back(off(i));
  }
  return out;
}

double Reach(const std::vector<double>& values, double least) {
  std::vector<double> sorted;
  for (const double v : values)
    sorted.push_back(std::abs(v));
  std::ranges::sort(sorted);
  return sorted.empty() ? least : std::max(least, sorted[sorted.size() * 98 / 100]);
}

std::vector<Point> PointsOf(const MapAxes& map, const std::vector<SmoothedPose>& poses) {
  std::vector<Point> points;
  for (const SmoothedPose& pose : poses) {
    points.push_back(map.At(pose.X_WB.p_WB.head<2>()));
  }
  return Simplified(points, 0.3);
}

SurveyArea AreaOf(const ReplayResult& result) {
  SurveyArea area{.north_min = 1e9, .north_max = -1e9, .east_min = 1e9, .east_max = -1e9};
  const auto cover = [&area](const Eigen::Vector3d& p) {
    area.north_min = std::min(area.north_min, p.x());
    area.north_max = std::max(area.north_max, p.x());
    area.east_min = std::min(area.east_min, p.y());
    area.east_max = std::max(area.east_max, p.y());
  };
  for (const SmoothedPose& pose : result.smoothed)
    cover(pose.X_WB.p_WB);
  for (const Landmark& landmark : result.landmarks)
    cover(landmark.object.p_W);
  return area;
}

}  // namespace

std::string NavErrorPlot(const ReplayResult& result, const std::string& name) {
  const Differences online = DifferencesOf(result.online, result);
  const Differences reckoned = DifferencesOf(result.reckoned, result);
  constexpr double kPanel = 128.0, kGap = 20.0, kTop = 92.0;
  constexpr const char* kAxes[] = {"north [m]", "east [m]", "down [m]"};
  SvgCanvas canvas({chart::kLeft + chart::kWidth + 24.0, kTop + 3.0 * (kPanel + kGap) + 40.0},
                   "Online estimate");
  canvas.Text({chart::kLeft, 24.0}, "Estimate as known at the time, less what is known at the end",
              {.size = 16.0, .is_bold = true});
  canvas.Text({chart::kLeft, 44.0},
              fmt::format("{} \u00b7 {} poses, {} objects \u00b7 no truth is read", name,
                          result.smoothed.size(), result.landmarks.size()),
              {.size = 12.5, .fill = palette::kMuted});
  DrawKey(canvas, {chart::kLeft, 71.0}, "estimate", kOnline);
  DrawKey(canvas, {chart::kLeft + 120.0, 71.0}, "dead reckoning", kDeadReckoning);
  canvas.Rect({chart::kLeft + 280.0, 65.0}, {26.0, 12.0}, chart::kBounds);
  canvas.Text({chart::kLeft + 313.0, 75.0}, "\u00b13 standard deviations, as the estimator says");
  for (int i = 0; i < 3; ++i) {
    std::vector<double> low, high;
    for (const Eigen::Matrix3d& covariance : result.online_covariance_W) {
      high.push_back(3.0 * std::sqrt(std::max(covariance(i, i), 0.0)));
      low.push_back(-high.back());
    }
    const double reach = 1.1 * std::max({Reach(online.axis[i], 0.05), Reach(high, 0.05),
                                         i < 2 ? Reach(reckoned.axis[i], 0.05) : 0.05});
    PlotAxes axes(canvas, {.corner = {chart::kLeft, kTop + i * (kPanel + kGap)},
                           .size = {chart::kWidth, kPanel},
                           .x = {0.0, std::max(online.minutes.back(), 0.1)},
                           .y = {-reach, reach},
                           .x_label = "time [min]",
                           .y_label = kAxes[i],
                           .has_x_labels = i == 2,
                           .y_ticks = 5});
    axes.Band(online.minutes, low, high, chart::kBounds);
    axes.Level(0.0, {.stroke = palette::kMuted, .width = 0.8});
    if (i < 2) axes.Curve(reckoned.minutes, reckoned.axis[i], kDeadReckoning);
    axes.Curve(online.minutes, online.axis[i], kOnline);
  }
  return canvas.Finish();
}

std::string NavMapPlot(const ReplayResult& result, const std::string& name) {
  MapAxes map(AreaOf(result), "Track and objects",
              fmt::format("{} \u00b7 smoothed, {} objects", name, result.landmarks.size()));
  map.BeginMap();
  map.canvas().Polyline(PointsOf(map, result.reckoned), kDeadReckoning);
  map.canvas().Polyline(PointsOf(map, result.smoothed), kTrack);
  for (const Landmark& landmark : result.landmarks) {
    const Point at = map.At(landmark.object.p_W.head<2>());
    const Eigen::Matrix3d& S = landmark.object.cov_W;
    DrawCovariance(map.canvas(), at, 3.0 * map.pixels_per_metre(), {S(0, 0), S(0, 1), S(1, 1)},
                   kEllipse);
    map.canvas().Circle(at, 3.5, {.fill = palette::kMapInk});
  }
  for (const Landmark& landmark : result.landmarks) {
    DrawLabel(map, landmark.object.p_W,
              {.lines = {fmt::format("{}", landmark.id)}, .distance = 7.0});
  }
  map.EndMap();
  map.LegendHeading("Vehicle");
  const auto line = [](const Paint& paint) {
    return [paint](SvgCanvas& canvas, const Point& at) {
      canvas.Line(at - Point(12.0, 0.0), at + Point(12.0, 0.0), paint);
    };
  };
  map.Legend(line(kTrack), "smoothed track");
  map.Legend(line(kDeadReckoning), "dead reckoning");
  map.LegendHeading("Objects");
  map.Legend(
      [](SvgCanvas& canvas, const Point& at) {
        canvas.Circle(at, 9.0, kEllipse);
        canvas.Circle(at, 3.5, {.fill = palette::kMapInk});
      },
      "place, 3 standard deviations\n(in the world: what GPS and\nheading leave open is\ncommon to "
      "all)");
  return map.Finish();
}

}  // namespace limpet
