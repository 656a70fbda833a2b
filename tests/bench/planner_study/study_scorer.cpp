// SPDX-License-Identifier: MIT
#include "tests/bench/planner_study/study_scorer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace limpet {
namespace {

constexpr double kCell = 0.25;
constexpr double kRadius = 0.5;
constexpr double kShare = 0.6;
constexpr int kFrames = 3;
constexpr int kDiscPoints = 64;

struct Offset {
  double forward, starboard;
};

/// Points of equal area on a disc (sunflower).
std::array<Offset, kDiscPoints> DiscPoints() {
  std::array<Offset, kDiscPoints> points{};
  for (int i = 0; i < kDiscPoints; ++i) {
    const double r = kRadius * std::sqrt((i + 0.5) / kDiscPoints);
    const double angle = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
    points[static_cast<std::size_t>(i)] = {r * std::cos(angle), r * std::sin(angle)};
  }
  return points;
}

}  // namespace

void LevelLog::Note(double path, double share) {
  if (steps_.empty() || share > steps_.back().share) {
    steps_.push_back({path, share});
  }
}

std::optional<double> LevelLog::PathAt(double level) const {
  for (const Step& step : steps_) {
    if (step.share >= level) {
      return step.path;
    }
  }
  return std::nullopt;
}

StudyScorer::StudyScorer(const SurveyArea& area, double altitude, const CameraModel& camera,
                         Random& random)
    : altitude_(altitude),
      tan_across_(camera.half_across()),
      tan_along_(camera.half_along()),
      north_min_(area.north_min),
      east_min_(area.east_min),
      rows_(static_cast<int>(std::lround((area.north_max - area.north_min) / kCell))),
      columns_(static_cast<int>(std::lround((area.east_max - area.east_min) / kCell))) {
  const double top = std::max(kRadius, area.object_height_max);
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const auto draw = [&](double low, double high) {
        return static_cast<float>(random.Uniform(low, high));
      };
      const double north = north_min_ + row * kCell, east = east_min_ + column * kCell;
      bottom_.push_back({draw(north, north + kCell), draw(east, east + kCell), 0.0F, 0});
      objects_.push_back(
          {draw(north, north + kCell), draw(east, east + kCell), draw(kRadius, top), 0});
    }
  }
}

bool StudyScorer::ShowsDisc(double forward, double starboard, double height) const {
  static const std::array<Offset, kDiscPoints> kPoints = DiscPoints();
  const double along = (altitude_ - height) * tan_along_;
  const double across = (altitude_ - height) * tan_across_;
  const double inside = std::min(along - std::abs(forward), across - std::abs(starboard));
  if (inside >= kRadius) {
    return true;
  }
  if (inside < 0.0) {  // less than half the disc
    return false;
  }
  const auto count = std::count_if(kPoints.begin(), kPoints.end(), [&](const Offset& point) {
    return std::abs(forward + point.forward) <= along &&
           std::abs(starboard + point.starboard) <= across;
  });
  return static_cast<double>(count) >= kShare * kDiscPoints;
}

void StudyScorer::Frame(const Pose2& at, double path) {
  const double reach = altitude_ * std::hypot(tan_across_, tan_along_);
  const auto cell = [](double offset, int count) {
    return std::clamp(static_cast<int>(std::floor(offset / kCell)), 0, count - 1);
  };
  const double c = std::cos(at.yaw), s = std::sin(at.yaw);
  const int row_end = cell(at.north + reach - north_min_, rows_);
  const int column_end = cell(at.east + reach - east_min_, columns_);
  for (int row = cell(at.north - reach - north_min_, rows_); row <= row_end; ++row) {
    for (int column = cell(at.east - reach - east_min_, columns_); column <= column_end; ++column) {
      const auto i = static_cast<std::size_t>(row * columns_ + column);
      Sample& bottom = bottom_[i];
      if (bottom.frames == 0) {
        const double dn = bottom.north - at.north, de = bottom.east - at.east;
        if (std::abs(dn * c + de * s) <= altitude_ * tan_along_ &&
            std::abs(-dn * s + de * c) <= altitude_ * tan_across_) {
          bottom.frames = 1;
          ++bottom_seen_;
        }
      }
      Sample& object = objects_[i];
      if (object.frames < kFrames) {
        const double dn = object.north - at.north, de = object.east - at.east;
        if (ShowsDisc(dn * c + de * s, -dn * s + de * c, object.height) &&
            ++object.frames == kFrames) {
          ++objects_seen_;
        }
      }
    }
  }
  const auto count = static_cast<double>(bottom_.size());
  seabed_log_.Note(path, static_cast<double>(bottom_seen_) / count);
  band_log_.Note(path, static_cast<double>(objects_seen_) / count);
}

}  // namespace limpet
