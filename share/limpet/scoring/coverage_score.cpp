// SPDX-License-Identifier: MIT
#include "limpet/scoring/coverage_score.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "limpet/core/random.hpp"
#include "limpet/mission/seabed.hpp"
#include "limpet/scoring/disc_in_rectangle.hpp"
#include "limpet/survey/survey_shape.hpp"

namespace limpet {
namespace {

constexpr double kCell = 0.25;
constexpr double kShareOfDisc = 0.6;
constexpr int kFramesToDetect = 3;
constexpr double kLevels[] = {0.90, 0.95, 0.99};

/// One jittered point on the seabed, and one object centre at a random height above another.
struct Sample {
  Eigen::Vector3d seabed, object;
  double height_m;  ///< of the object above the seabed
  bool is_covered = false;
  std::uint8_t frames = 0;  ///< in which the object was seen well
};

class SampleGrid {
 public:
  SampleGrid(const SurveyArea& area, const Scenario& scenario, const ReportSettings& settings);
  void See(const Pose& X_WB, const CameraModel& camera, double radius);
  /// Shares of the ground, and of the places of objects, that are in the area and in no zone.
  [[nodiscard]] double covered() const { return covered_ / std::max(1.0, seabed_wanted_); }
  [[nodiscard]] double detected() const { return detected_ / std::max(1.0, objects_wanted_); }
  /// Where an object has not been seen well.
  [[nodiscard]] std::vector<UnseenPlace> Unseen() const;
  [[nodiscard]] double objects_wanted() const { return objects_wanted_; }

 private:
  struct Window {
    int row_begin, row_end, column_begin, column_end;
  };
  void LeaveOutUnwanted(const SurveyShape& shape);
  [[nodiscard]] Window WindowOf(const Pose& X_WB, const CameraModel& camera, double margin) const;
  SurveyArea area_;
  int rows_, columns_;
  double deepest_ = 0.0;
  std::vector<Sample> samples_;
  double covered_ = 0.0, detected_ = 0.0;
  double seabed_wanted_ = 0.0, objects_wanted_ = 0.0;
};

SampleGrid::SampleGrid(const SurveyArea& area, const Scenario& scenario,
                       const ReportSettings& settings)
    : area_(area),
      rows_(std::max(
          1, static_cast<int>(std::ceil((area.north_max - area.north_min) / kCell - 1e-9)))),
      columns_(std::max(
          1, static_cast<int>(std::ceil((area.east_max - area.east_min) / kCell - 1e-9)))) {
  // The same points in every run: a score must not depend on the seed of what it judges.
  Random random(20250101, "coverage samples");
  const double top = std::max(settings.object_radius_m, settings.object_height_max_m);
  const double row_m = (area.north_max - area.north_min) / rows_;
  const double column_m = (area.east_max - area.east_min) / columns_;
  const Seabed bottom(scenario.seabed);
  samples_.reserve(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_));
  const auto draw = [&](int row, int column, double height) {
    const double north = area.north_min + (row + random.Uniform(0.0, 1.0)) * row_m;
    const double east = area.east_min + (column + random.Uniform(0.0, 1.0)) * column_m;
    const double seabed = bottom.Depth(north, east);
    deepest_ = std::max(deepest_, seabed);
    return Eigen::Vector3d(north, east, seabed - height);
  };
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const Eigen::Vector3d seabed = draw(row, column, 0.0);
      const double height = random.Uniform(settings.object_radius_m, top);
      samples_.push_back({seabed, draw(row, column, height), height});
    }
  }
  seabed_wanted_ = objects_wanted_ = static_cast<double>(samples_.size());
  // A log may hold anything: an area that is none is scored as its box.
  if (const auto shape = SurveyShape::Of(area); shape && !shape->is_plain()) {
    LeaveOutUnwanted(*shape);
  }
}

void SampleGrid::LeaveOutUnwanted(const SurveyShape& shape) {
  for (Sample& sample : samples_) {
    if (!shape.Wants(sample.seabed.head<2>())) {
      sample.is_covered = true;  // once and for all: it is not counted
      seabed_wanted_ -= 1.0;
    }
    if (!shape.Wants(sample.object.head<2>())) {
      sample.frames = kFramesToDetect;
      objects_wanted_ -= 1.0;
    }
  }
}

SampleGrid::Window SampleGrid::WindowOf(const Pose& X_WB, const CameraModel& camera,
                                        double margin) const {
  const Eigen::Matrix3d R_WC = RotationOf(X_WB) * camera.R_BC;
  const Eigen::Vector3d eye = X_WB.p_WB + RotationOf(X_WB) * camera.p_BC;
  Eigen::Vector2d low = eye.head<2>(), high = low;
  for (const double across : {-1.0, 1.0}) {
    for (const double along : {-1.0, 1.0}) {
      const Eigen::Vector3d ray =
          R_WC * Eigen::Vector3d(across * camera.half_across(), along * camera.half_along(), 1.0);
      // A corner that looks at the horizon sees far; what it sees there is tested sample by sample.
      const double reach = (deepest_ - eye.z()) / std::max(ray.z(), 0.1);
      const Eigen::Vector2d corner = eye.head<2>() + std::max(reach, 0.0) * ray.head<2>();
      low = low.cwiseMin(corner), high = high.cwiseMax(corner);
    }
  }
  const auto index = [](double offset, int count) {
    return std::clamp(static_cast<int>(std::floor(offset / kCell)), 0, count);
  };
  return {index(low.x() - margin - area_.north_min - kCell, rows_),
          index(high.x() + margin - area_.north_min + 2.0 * kCell, rows_),
          index(low.y() - margin - area_.east_min - kCell, columns_),
          index(high.y() + margin - area_.east_min + 2.0 * kCell, columns_)};
}

void SampleGrid::See(const Pose& X_WB, const CameraModel& camera, double radius) {
  const Eigen::Matrix3d R_CW = (RotationOf(X_WB) * camera.R_BC).transpose();
  const Eigen::Vector3d offset = -R_CW * X_WB.p_WB - camera.R_BC.transpose() * camera.p_BC;
  const double across = camera.half_across();
  const double along = camera.half_along();
  const Window window = WindowOf(X_WB, camera, radius);
  for (int row = window.row_begin; row < window.row_end; ++row) {
    for (int column = window.column_begin; column < window.column_end; ++column) {
      Sample& sample = samples_[static_cast<std::size_t>(row * columns_ + column)];
      if (!sample.is_covered) {
        const Eigen::Vector3d p = R_CW * sample.seabed + offset;
        if (p.z() > 0.0 && std::abs(p.x()) <= across * p.z() && std::abs(p.y()) <= along * p.z()) {
          sample.is_covered = true;
          covered_ += 1.0;
        }
      }
      if (sample.frames < kFramesToDetect) {
        const Eigen::Vector3d p = R_CW * sample.object + offset;
        if (p.z() > radius &&
            ShareOfDiscInRectangle(p.head<2>(), radius, {across * p.z(), along * p.z()}) >=
                kShareOfDisc) {
          if (++sample.frames == kFramesToDetect) detected_ += 1.0;
        }
      }
    }
  }
}

std::vector<UnseenPlace> SampleGrid::Unseen() const {
  std::vector<UnseenPlace> places;
  for (const Sample& sample : samples_) {
    if (sample.frames >= kFramesToDetect) continue;
    places.push_back({.at_W = sample.object.head<2>(),
                      .height_m = sample.height_m,
                      .was_seen = sample.frames > 0});
  }
  return places;
}

UnseenScore UnseenOf(const SampleGrid& grid, const SurveyArea& area,
                     const ReportSettings& settings) {
  UnseenScore score{.bottom = 1.0 - grid.covered(), .band = 1.0 - grid.detected()};
  const auto counts = CountReasons(grid.Unseen(), area, settings);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    score.band_by_reason[i] = static_cast<double>(counts[i]) / std::max(1.0, grid.objects_wanted());
  }
  return score;
}

/// True once the place has been in the image within visibility, or nearly under the vehicle.
bool HasSeen(const Pose& X_WB, const Eigen::Vector3d& place, const CameraModel& camera,
             double visibility) {
  if ((place - X_WB.p_WB).head<2>().norm() <= 1.5) return true;
  const Eigen::Vector3d p = camera.InCamera(X_WB, place);
  return p.z() > 0.0 && p.norm() <= visibility && std::abs(p.x()) <= p.z() * camera.half_across() &&
         std::abs(p.y()) <= p.z() * camera.half_along();
}

std::vector<CoverageLevel> LevelsOf(const CoverageCurve& curve, const std::vector<double>& share) {
  std::vector<CoverageLevel> levels;
  for (const double level : kLevels) {
    CoverageLevel entry{level, std::nullopt, std::nullopt};
    const auto reached = std::lower_bound(share.begin(), share.end(), level);
    if (reached != share.end()) {
      const auto i = static_cast<std::size_t>(reached - share.begin());
      entry.path_m = curve.path_m[i];
      entry.time_s = curve.time_s[i];
    }
    levels.push_back(entry);
  }
  return levels;
}

std::optional<double> PathToSee(const SurveyFrames& frames, std::vector<Eigen::Vector3d> places,
                                const CameraModel& camera, double visibility) {
  if (places.empty()) return std::nullopt;
  const auto look = [&](const Pose& X_WB) {
    std::erase_if(places, [&](const Eigen::Vector3d& place) {
      return HasSeen(X_WB, place, camera, visibility);
    });
    return places.empty();
  };
  for (const Pose& X_WB : frames.dive_X_WB) {
    if (look(X_WB)) return 0.0;
  }
  for (std::size_t i = 0; i < frames.X_WB.size(); ++i) {
    if (look(frames.X_WB[i])) return frames.path_m[i];
  }
  return std::nullopt;
}

}  // namespace

SurveyFrames FramesOfSurvey(const SessionRecord& record, const ReportSettings& settings) {
  SurveyFrames frames;
  const auto start = record.PhaseStart("SURVEY");
  if (!start || record.truth.empty()) return frames;
  const auto ascent = record.PhaseStart("ASCEND");
  const double last = record.truth.time(record.truth.size() - 1);
  const double end = ascent ? std::min(ascent->value(), last) : last;
  const double period = 1.0 / settings.frame_rate_hz;
  frames.start_s = start->value();
  frames.start_path_m = record.truth.PathAt(start->value());
  const auto dive = record.PhaseStart("DIVE").value_or(*start);
  for (double k = std::ceil(dive.value() / period); k * period < start->value(); k += 1.0) {
    if (const auto X_WB = record.truth.At(k * period)) frames.dive_X_WB.push_back(*X_WB);
  }
  for (double k = std::ceil(start->value() / period); k * period <= end; k += 1.0) {
    const double time = k * period;
    const auto X_WB = record.truth.At(time);
    if (!X_WB) continue;
    frames.time_s.push_back(time - frames.start_s);
    frames.path_m.push_back(record.truth.PathAt(time) - frames.start_path_m);
    frames.X_WB.push_back(*X_WB);
  }
  return frames;
}

CoverageScore ScoreCoverage(const SurveyFrames& frames, const SurveyArea& area,
                            const Scenario& scenario, const ReportSettings& settings,
                            const std::vector<Eigen::Vector3d>& former) {
  CoverageScore score;
  SampleGrid grid(area, scenario, settings);
  score.curve.path_m = frames.path_m;
  score.curve.time_s = frames.time_s;
  for (const Pose& X_WB : frames.X_WB) {
    grid.See(X_WB, settings.camera_geometry, settings.object_radius_m);
    score.curve.seabed.push_back(grid.covered());
    score.curve.band.push_back(grid.detected());
  }
  score.covered = grid.covered();
  score.detected_band = grid.detected();
  score.unseen = UnseenOf(grid, area, settings);
  score.seabed = LevelsOf(score.curve, score.curve.seabed);
  score.band = LevelsOf(score.curve, score.curve.band);
  score.prior_opis_seen_path_m =
      PathToSee(frames, former, settings.camera_geometry, scenario.water.visibility_m);
  return score;
}

}  // namespace limpet
