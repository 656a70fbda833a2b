// SPDX-License-Identifier: MIT
#include "estimation/mapping/obstacle_finder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "estimation/mapping/obstacle_outline.hpp"

namespace limpet {
namespace {

/// Echoes from deeper than that below the vehicle are of what it passes over [m].
constexpr double kInTheWay = 1.0;
/// Lower than that above the seabed is its relief [m].
constexpr double kRelief = 1.0;

double FarthestOutside(const Obstacle& of, const Obstacle& from) {
  double farthest = 0.0;
  for (const auto& [north, east] : of.outline) {
    farthest = std::max(farthest, Outside(from.outline, {north, east}));
  }
  return farthest;
}

Eigen::Vector2d MiddleOf(const Obstacle& obstacle) {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const auto& [north, east] : obstacle.outline) {
    middle += Eigen::Vector2d(north, east) / static_cast<double>(obstacle.outline.size());
  }
  return middle;
}

}  // namespace

bool ObstacleFinder::StandsUp(const Eigen::Vector3d& end_W, double vehicle_down) const {
  if (end_W.z() > vehicle_down + kInTheWay) return false;
  const std::optional<double> seabed = ground_.DepthAt(end_W.head<2>());
  return !seabed || end_W.z() < *seabed - kRelief;
}

void ObstacleFinder::AddBeams(double t, const PosedBeams& ping) {
  const std::array<std::optional<double>, 4> ranges{ping.b1, ping.b2, ping.b3, ping.b4};
  const Pose X_WD = ping.pose();
  ground_.Add(X_WD, ranges, dvl_);
  const Eigen::Matrix3d R_WD = RotationOf(X_WD);
  const auto directions = BeamDirections(dvl_);
  for (std::size_t beam = 0; beam < ranges.size(); ++beam) {
    if (!ranges[beam]) continue;
    const Eigen::Vector3d end_W = X_WD.p_WB + R_WD * (*ranges[beam] * directions[beam]);
    if (!StandsUp(end_W, ping.down)) continue;
    cells_.AddEcho(t, end_W);
    has_news_ = true;
  }
}

void ObstacleFinder::AddSonar(double t, const PosedSonar& sonar) {
  cells_.AddPassages(sonar);
  has_news_ = has_news_ || !cells_.is_empty();
  const Eigen::Matrix3d R_WB = RotationOf(sonar.pose());
  double bearing = sonar.ping.first - sonar.ping.step;
  for (const double range : sonar.ping.ranges) {
    bearing += sonar.ping.step;
    if (!(range > 0.0 && range <= sonar.ping.reach)) continue;
    const Eigen::Vector3d end_W =
        sonar.pose().p_WB +
        R_WB * (range * Eigen::Vector3d(std::cos(bearing), std::sin(bearing), 0.0));
    if (!StandsUp(end_W, sonar.down)) continue;
    cells_.AddEcho(t, end_W);
    has_news_ = true;
  }
}

void ObstacleFinder::Shift(const TrackShift& shift) {
  cells_.Shift(shift);
  has_news_ = has_news_ || !cells_.is_empty();
}

std::optional<Obstacle> ObstacleFinder::TakeFormer(const Obstacle& now,
                                                   std::vector<Obstacle>& known) const {
  constexpr double kNear = 2.0;  // [m]
  auto nearest = known.end();
  double least = kNear;
  for (auto it = known.begin(); it != known.end(); ++it) {
    const double distance = (MiddleOf(*it) - MiddleOf(now)).norm();
    if (distance < least) least = distance, nearest = it;
  }
  if (nearest == known.end()) return std::nullopt;
  Obstacle former = std::move(*nearest);
  known.erase(nearest);
  return former;
}

bool ObstacleFinder::Update() {
  constexpr double kGrown = 0.2, kShrunk = 0.5;  // [m]; below them paths would change for nothing
  if (!has_news_) return false;
  has_news_ = false;
  std::vector<Obstacle> known = obstacles_, current;
  bool has_changed = false;
  for (const auto& group : GroupsOf(cells_.Believed(), cells_.cell_m())) {
    Obstacle now{.id = 0, .outline = OutlineOf(group, 0.5 * cells_.cell_m()), .top = 0.0};
    now.top = std::ranges::min_element(group, {}, &EchoCells::Cell::shallowest)->shallowest;
    if (const std::optional<Obstacle> former = TakeFormer(now, known)) {
      const bool is_same =
          FarthestOutside(now, *former) <= kGrown && FarthestOutside(*former, now) <= kShrunk;
      has_changed = has_changed || !is_same;
      now.id = former->id;
      current.push_back(is_same ? *former : now);
    } else {
      now.id = next_id_++;
      current.push_back(std::move(now));
      has_changed = true;
    }
  }
  has_changed = has_changed || !known.empty();
  if (has_changed) obstacles_ = std::move(current);
  return has_changed;
}

}  // namespace limpet
