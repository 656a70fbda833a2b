// SPDX-License-Identifier: MIT
#include "limpet/scoring/coverage_score.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "limpet/core/random.hpp"
#include "limpet/mission/seabed.hpp"
#include "limpet/scoring/disc_in_rectangle.hpp"
#include "limpet/survey/sight_obstacles.hpp"
#include "limpet/survey/survey_shape.hpp"
#include "limpet/topics/survey_phase.hpp"

namespace limpet {
namespace {

constexpr double kCell = 0.25;
constexpr double kShareOfDisc = 0.6;
constexpr int kFramesToDetect = 3;
constexpr double kLevels[] = {0.90, 0.95, 0.99};

/// Rows that are drawn and judged at a time: a square kilometre would need a gigabyte at once.
constexpr int kBandRows = 64;

/// One jittered point on the seabed, and one object centre at a random height above another.
struct Sample {
  Eigen::Vector3d seabed, object;
  double height_m;  ///< of the object above the seabed
  bool is_covered = false;
  std::uint8_t frames = 0;  ///< in which the object was seen well
  bool was_hidden = false;  ///< the object, by an obstacle
};

/// What one frame has shown first: points on the seabed, and objects.
struct NewlySeenSamples {
  int covered = 0, detected = 0;
};

/// Samples of all the area, of which a band of rows at a time is there.
class SampleBands {
 public:
  SampleBands(const SurveyArea& area, const Scenario& scenario, const ReportSettings& settings);
  /// Draws the next band; false if there is none.
  bool Next();
  /// Shows the band what the camera sees.
  NewlySeenSamples See(const Pose& X_WB, const CameraModel& camera, double radius);
  /// Adds where an object has not been seen well.
  void CountUnseen(UnseenCounter& counter) const;
  /// How many of those drawn so far are in the area and in no zone.
  [[nodiscard]] double seabed_wanted() const { return seabed_wanted_; }
  [[nodiscard]] double objects_wanted() const { return objects_wanted_; }
  /// ... and in no zone, where an obstacle stands.
  [[nodiscard]] double seabed_stood_on() const { return seabed_stood_on_; }
  [[nodiscard]] double objects_stood_on() const { return objects_stood_on_; }

 private:
  struct Window {
    int row_begin, row_end, column_begin, column_end;
  };
  [[nodiscard]] Eigen::Vector3d Draw(int row, int column, double height);
  void LeaveOutUnwanted(Sample& sample);
  /// Counts a place of a sample; false if it is not to be seen.
  [[nodiscard]] bool CountPlace(const Eigen::Vector3d& place, double& wanted,
                                double& stood_on) const;
  [[nodiscard]] Window WindowOf(const Pose& X_WB, const CameraModel& camera, double margin) const;
  SurveyArea area_;
  std::optional<SurveyShape> shape_;  ///< nothing if all of the box is wanted
  int rows_, columns_;
  Seabed bottom_;
  double lowest_, top_;  ///< heights of objects' centres [m]
  /// The same points in every run: a score must not depend on the seed of what it judges.
  Random random_{20250101, "coverage samples"};
  int first_row_ = -kBandRows;
  double deepest_ = 0.0;  ///< of the band
  std::vector<Sample> samples_;
  double seabed_wanted_ = 0.0, objects_wanted_ = 0.0;
  std::vector<UprightBody> bodies_;    ///< all that a camera does not see through
  std::vector<UprightBody> standing_;  ///< the vehicle has to go round them
  double seabed_stood_on_ = 0.0, objects_stood_on_ = 0.0;
};

/// Whether one stands between the camera and a place, and not on it: tops are seen.
bool AreBetween(const std::vector<UprightBody>& bodies, const Eigen::Vector3d& eye_W,
                const Eigen::Vector3d& place_W) {
  return std::ranges::any_of(bodies, [&](const UprightBody& body) {
    return !body.Covers(place_W.head<2>()) && body.IsBetween(eye_W, place_W);
  });
}

/// Obstacles that reach up to where pMap takes an echo for something in the way of a vehicle at
/// survey altitude. It passes over lower ones and sees their tops.
std::vector<UprightBody> StandingBodies(const Scenario& scenario, double altitude) {
  constexpr double kBelowVehicle = 1.0, kRelief = 1.0;  // [m]
  std::vector<UprightBody> standing;
  for (const ScenarioObstacle& obstacle : scenario.obstacles) {
    if (obstacle.height_m >= std::max(kRelief, altitude - kBelowVehicle)) {
      standing.push_back(obstacle.Body(scenario.seabed));
    }
  }
  return standing;
}

SampleBands::SampleBands(const SurveyArea& area, const Scenario& scenario,
                         const ReportSettings& settings)
    : area_(area),
      rows_(std::max(
          1, static_cast<int>(std::ceil((area.north_max - area.north_min) / kCell - 1e-9)))),
      columns_(
          std::max(1, static_cast<int>(std::ceil((area.east_max - area.east_min) / kCell - 1e-9)))),
      bottom_(scenario.seabed),
      lowest_(settings.object_radius_m),
      top_(std::max(settings.object_radius_m, settings.object_height_max_m)),
      bodies_(BodiesOf(scenario)),
      standing_(StandingBodies(scenario, settings.altitude_m)) {
  // A log may hold anything: an area that is none is scored as its box.
  if (const auto shape = SurveyShape::Of(area); shape && !shape->is_plain()) shape_ = *shape;
}

Eigen::Vector3d SampleBands::Draw(int row, int column, double height) {
  const double row_m = (area_.north_max - area_.north_min) / rows_;
  const double column_m = (area_.east_max - area_.east_min) / columns_;
  const double north = area_.north_min + (row + random_.Uniform(0.0, 1.0)) * row_m;
  const double east = area_.east_min + (column + random_.Uniform(0.0, 1.0)) * column_m;
  const double seabed = bottom_.Depth({north, east});
  deepest_ = std::max(deepest_, seabed);
  return {north, east, seabed - height};
}

bool SampleBands::Next() {
  first_row_ += kBandRows;
  samples_.clear();
  deepest_ = 0.0;
  const int end = std::min(first_row_ + kBandRows, rows_);
  for (int row = first_row_; row < end; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const Eigen::Vector3d seabed = Draw(row, column, 0.0);
      const double height = random_.Uniform(lowest_, top_);
      samples_.push_back({seabed, Draw(row, column, height), height});
      LeaveOutUnwanted(samples_.back());
    }
  }
  return !samples_.empty();
}

void SampleBands::LeaveOutUnwanted(Sample& sample) {
  // What is not to be seen is so once and for all: it is not counted.
  if (!CountPlace(sample.seabed, seabed_wanted_, seabed_stood_on_)) sample.is_covered = true;
  if (!CountPlace(sample.object, objects_wanted_, objects_stood_on_)) {
    sample.frames = kFramesToDetect;
  }
}

bool SampleBands::CountPlace(const Eigen::Vector3d& place, double& wanted, double& stood_on) const {
  if (shape_ && !shape_->Wants(place.head<2>())) return false;
  const bool is_stood_on = std::ranges::any_of(
      standing_, [&place](const UprightBody& body) { return body.Covers(place.head<2>()); });
  (is_stood_on ? stood_on : wanted) += 1.0;
  return !is_stood_on;
}

SampleBands::Window SampleBands::WindowOf(const Pose& X_WB, const CameraModel& camera,
                                          double margin) const {
  const Eigen::Matrix3d R_WC = RotationOf(X_WB) * camera.R_BC;
  const Eigen::Vector3d eye = EyeOf(camera, X_WB);
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
  const auto index = [](double offset, int begin, int end) {
    return std::clamp(static_cast<int>(std::floor(offset / kCell)), begin, end);
  };
  const int end_row = std::min(first_row_ + kBandRows, rows_);
  return {index(low.x() - margin - area_.north_min - kCell, first_row_, end_row),
          index(high.x() + margin - area_.north_min + 2.0 * kCell, first_row_, end_row),
          index(low.y() - margin - area_.east_min - kCell, 0, columns_),
          index(high.y() + margin - area_.east_min + 2.0 * kCell, 0, columns_)};
}

NewlySeenSamples SampleBands::See(const Pose& X_WB, const CameraModel& camera, double radius) {
  NewlySeenSamples seen;
  const Window window = WindowOf(X_WB, camera, radius);
  if (window.row_begin >= window.row_end) return seen;
  const Eigen::Matrix3d R_CW = (RotationOf(X_WB) * camera.R_BC).transpose();
  const Eigen::Vector3d offset = -R_CW * X_WB.p_WB - camera.R_BC.transpose() * camera.p_BC;
  const Eigen::Vector3d eye_W = EyeOf(camera, X_WB);
  const double across = camera.half_across();
  const double along = camera.half_along();
  for (int row = window.row_begin; row < window.row_end; ++row) {
    for (int column = window.column_begin; column < window.column_end; ++column) {
      Sample& sample = samples_[static_cast<std::size_t>((row - first_row_) * columns_ + column)];
      if (!sample.is_covered) {
        const Eigen::Vector3d p = R_CW * sample.seabed + offset;
        if (p.z() > 0.0 && std::abs(p.x()) <= across * p.z() && std::abs(p.y()) <= along * p.z() &&
            !AreBetween(bodies_, eye_W, sample.seabed)) {
          sample.is_covered = true;
          ++seen.covered;
        }
      }
      if (sample.frames < kFramesToDetect) {
        const Eigen::Vector3d p = R_CW * sample.object + offset;
        if (p.z() > radius &&
            ShareOfDiscInRectangle(p.head<2>(), radius, {across * p.z(), along * p.z()}) >=
                kShareOfDisc) {
          if (AreBetween(bodies_, eye_W, sample.object)) {
            sample.was_hidden = true;
          } else if (++sample.frames == kFramesToDetect)
            ++seen.detected;
        }
      }
    }
  }
  return seen;
}

void SampleBands::CountUnseen(UnseenCounter& counter) const {
  for (const Sample& sample : samples_) {
    if (sample.frames >= kFramesToDetect) continue;
    counter.Add({.at_W = sample.object.head<2>(),
                 .height_m = sample.height_m,
                 .was_seen = sample.frames > 0,
                 .was_hidden = sample.was_hidden});
  }
}

/// Shares of all the area, with what obstacles stand on.
UnseenScore UnseenOf(const SampleBands& bands, double covered, double detected,
                     const UnseenCounter& counter) {
  const double points = std::max(1.0, bands.seabed_wanted() + bands.seabed_stood_on());
  const double objects = std::max(1.0, bands.objects_wanted() + bands.objects_stood_on());
  UnseenScore unseen{.bottom = 1.0 - covered / points, .band = 1.0 - detected / objects};
  for (std::size_t i = 0; i < kWaysUnseen; ++i) {
    unseen.band_by_reason[i] = static_cast<double>(counter.Of(static_cast<WhyUnseen>(i))) / objects;
  }
  unseen.band_by_reason[static_cast<std::size_t>(WhyUnseen::kObstacle)] +=
      bands.objects_stood_on() / objects;
  return unseen;
}

/// The frames of the dive that are taken from where a vehicle maps.
std::vector<Pose> MappedDive(const SurveyFrames& frames, const Scenario& scenario,
                             const ReportSettings& settings) {
  const Seabed bottom(scenario.seabed);
  std::vector<Pose> mapped;
  for (const Pose& X_WB : frames.dive_X_WB) {
    const double depth = bottom.Depth(X_WB.p_WB.head<2>());
    if (depth - X_WB.p_WB.z() <= settings.highest_view_m) mapped.push_back(X_WB);
  }
  return mapped;
}

/// The curve, which begins with what the dive has shown, and what it ends with.
void ScoreSamples(const SurveyFrames& frames, const SurveyArea& area, const Scenario& scenario,
                  const ReportSettings& settings, CoverageScore& score) {
  SampleBands bands(area, scenario, settings);
  UnseenCounter counter(area, settings);
  const std::vector<Pose> dive = MappedDive(frames, scenario, settings);
  std::vector<NewlySeenSamples> seen(frames.X_WB.size());
  NewlySeenSamples by_dive{};
  const auto see = [&](const Pose& X_WB, NewlySeenSamples& so_far) {
    const NewlySeenSamples now =
        bands.See(X_WB, settings.camera_geometry, settings.object_radius_m);
    so_far.covered += now.covered;
    so_far.detected += now.detected;
  };
  while (bands.Next()) {
    for (const Pose& X_WB : dive)
      see(X_WB, by_dive);
    for (std::size_t i = 0; i < frames.X_WB.size(); ++i)
      see(frames.X_WB[i], seen[i]);
    bands.CountUnseen(counter);
  }
  const double points = std::max(1.0, bands.seabed_wanted());
  const double objects = std::max(1.0, bands.objects_wanted());
  double covered = by_dive.covered, detected = by_dive.detected;
  for (const NewlySeenSamples& by_frame : seen) {
    covered += by_frame.covered, detected += by_frame.detected;
    score.curve.seabed.push_back(covered / points);
    score.curve.band.push_back(detected / objects);
  }
  score.covered = covered / points;
  score.detected_band = detected / objects;
  score.unseen = UnseenOf(bands, covered, detected, counter);
}

/// True once the place has been in the image within visibility, or nearly under the vehicle.
bool HasSeen(const Pose& X_WB, const Eigen::Vector3d& place, const CameraModel& camera,
             double visibility, const std::vector<UprightBody>& bodies) {
  if (AreBetween(bodies, EyeOf(camera, X_WB), place)) return false;
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
                                const CameraModel& camera, const Scenario& scenario) {
  if (places.empty()) return std::nullopt;
  const std::vector<UprightBody> bodies = BodiesOf(scenario);
  const auto look = [&](const Pose& X_WB) {
    std::erase_if(places, [&](const Eigen::Vector3d& place) {
      return HasSeen(X_WB, place, camera, scenario.water.visibility_m, bodies);
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
  const auto start = record.PhaseStart(SurveyPhase::kSurvey);
  if (!start || record.truth.empty()) return frames;
  const auto ascent = record.PhaseStart(SurveyPhase::kAscend);
  const double last = record.truth.time(record.truth.size() - 1);
  const double end = ascent ? std::min(ascent->value(), last) : last;
  const double period = 1.0 / settings.frame_rate_hz;
  frames.start_s = start->value();
  frames.start_path_m = record.truth.PathAt(start->value());
  const auto dive = record.PhaseStart(SurveyPhase::kDive).value_or(*start);
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
                            const std::vector<Eigen::Vector3d>& former_W) {
  CoverageScore score;
  score.curve.path_m = frames.path_m;
  score.curve.time_s = frames.time_s;
  ScoreSamples(frames, area, scenario, settings, score);
  score.seabed = LevelsOf(score.curve, score.curve.seabed);
  score.band = LevelsOf(score.curve, score.curve.band);
  score.prior_opis_seen_path_m = PathToSee(frames, former_W, settings.camera_geometry, scenario);
  return score;
}

}  // namespace limpet
