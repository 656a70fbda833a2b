// SPDX-License-Identifier: MIT
#include "estimation/mapping/ground_looks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "estimation/mapping/beam_walk.hpp"
#include "estimation/mapping/semantic_octree.hpp"

namespace limpet {
namespace {

constexpr std::size_t kTileColumns = std::size_t{kTileVoxels} * kTileVoxels;

/// Number of a voxel's column in its tile, row by row.
std::size_t PlaceInTile(const VoxelKey& key) {
  constexpr std::int64_t kInside = kTileVoxels - 1;
  return static_cast<std::size_t>((key[0] & kInside) << kTileBits | (key[1] & kInside));
}

}  // namespace

void GroundLooks::SetModel(const LookModel& model) {
  model_ = model;
  BeginAnew();
}

bool GroundLooks::IsNewLook(const ObservedFrame& frame, const Passage& passage) const {
  if (!passage.last_look) return true;
  const double turned = std::abs(WrapAngle(frame.X_WB.yaw - passage.last_look->yaw));
  const double gone = (frame.X_WB.p_WB - passage.last_look->p_WB).norm();
  return looks_.IsNewLook(Meters(gone), Radians(turned));
}

int GroundLooks::GoOn(Passage& passage, const std::vector<ObservedFrame>& frames,
                      const SemanticMap& map, int work) const {
  for (; passage.next_frame < frames.size(); ++passage.next_frame) {
    const ObservedFrame& frame = frames[passage.next_frame];
    if (!frame.altitude || !IsNewLook(frame, passage)) continue;
    if (work <= 0) return 0;
    work -= Look(frame, map, passage);
    passage.last_look = frame.X_WB;
  }
  return std::max(work, 1);
}

bool GroundLooks::Settle(const std::vector<ObservedFrame>& frames, const SemanticMap& map,
                         int work) {
  if (!map.beams().is_settled()) return false;
  work = GoOn(known_, frames, map, work);
  if (is_stale_ && !anew_) {
    anew_.emplace(Passage{});  // Clang 14 finds no default constructor from in here
    is_stale_ = false;
  }
  if (work == 0 || !anew_) return work > 0;
  if (GoOn(*anew_, frames, map, work) == 0) return false;
  TakeOver();
  return !is_stale_;
}

void GroundLooks::TakeOver() {
  std::set<TileKey> changed = std::move(known_.changed);
  for (const auto& [tile, columns] : known_.tiles) {
    changed.insert(tile);
  }
  known_ = *std::move(anew_);
  known_.changed.merge(changed);
  anew_.reset();
}

int GroundLooks::Look(const ObservedFrame& frame, const SemanticMap& map, Passage& passage) const {
  const double edge = map.resolution();
  const double corner =
      *frame.altitude * std::hypot(model_.camera.half_along(), model_.camera.half_across());
  const auto index = [edge](double x) { return static_cast<std::int64_t>(std::floor(x / edge)); };
  const Eigen::Vector3d& p_WB = frame.X_WB.p_WB;
  constexpr double kColumnsPerWork = 8.0;  // of those of which no depth is known
  int work = static_cast<int>(4.0 * corner * corner / (edge * edge) / kColumnsPerWork) + 1;
  for (std::int64_t row = index(p_WB.x() - corner); row <= index(p_WB.x() + corner); ++row) {
    for (std::int64_t column = index(p_WB.y() - corner); column <= index(p_WB.y() + corner);
         ++column) {
      const double north = (static_cast<double>(row) + 0.5) * edge;
      const double east = (static_cast<double>(column) + 0.5) * edge;
      const std::optional<double> down = map.beams().depths().DownAt({north, east});
      if (!down) continue;
      ++work;
      const std::optional<double> miss = MissAt(frame, map, {north, east, *down});
      if (!miss) continue;
      const VoxelKey key{row, column, 0};
      Columns& columns = passage.tiles[TileOf(key)];
      columns.resize(kTileColumns);
      Column& known = columns[PlaceInTile(key)];
      if (frame.exposure.value() - known.last > looks_.new_pass_gap.value()) {
        known.passes += known.pass;
        known.pass = 0.0;
      }
      known.pass = std::min(known.pass, *miss);
      known.last = frame.exposure.value();
      passage.changed.insert(TileOf(key));
    }
  }
  return work;
}

std::optional<double> GroundLooks::MissAt(const ObservedFrame& frame, const SemanticMap& map,
                                          const Eigen::Vector3d& ground_W) const {
  const Eigen::Vector3d centre_W = ground_W - Eigen::Vector3d(0.0, 0.0, model_.object_radius);
  const double chance = ChanceToDetect(model_, frame.X_WB, centre_W);
  if (chance < kLookChance) return std::nullopt;
  for (const Eigen::Vector3d& p_W : {centre_W, ground_W}) {
    const auto pixel = model_.camera.Project(model_.camera.InCamera(frame.X_WB, p_W));
    const bool has_box = pixel && std::ranges::any_of(frame.boxes, [&pixel](const Box& box) {
                           return std::abs(pixel->x() - box.u) <= 0.5 * box.w &&
                                  std::abs(pixel->y() - box.v) <= 0.5 * box.h;
                         });
    if (has_box) return std::nullopt;
  }
  if (!IsInSight(frame, map, ground_W)) return std::nullopt;
  const double missed = looks_.pass_failure + (1.0 - looks_.pass_failure) * (1.0 - chance);
  return std::min(0.0, std::log(missed / (1.0 - model_.detection.false_per_image)));
}

bool GroundLooks::IsInSight(const ObservedFrame& frame, const SemanticMap& map,
                            const Eigen::Vector3d& ground_W) const {
  constexpr double kShort = 2.0;  // voxels: the seabed is as thick as beams scatter
  const Eigen::Vector3d from = frame.X_WB.p_WB / map.resolution();
  const Eigen::Vector3d way = ground_W / map.resolution() - from;
  const double length = way.norm();
  if (length <= kShort) return true;
  BeamWalk walk(from, from + (1.0 - kShort / length) * way);
  while (true) {
    const VoxelIndex& at = walk.at();
    if (!map.IsClear({at[0], at[1], at[2]})) return false;
    if (walk.HasArrived()) return true;
    walk.Step();
  }
}

float GroundLooks::LogOdds(const VoxelKey& key) const {
  const auto found = known_.tiles.find(TileOf(key));
  if (found == known_.tiles.end()) return 0.0F;
  const Column& column = found->second[PlaceInTile(key)];
  return static_cast<float>(std::max(-kMostVoxelLogOdds, column.passes + column.pass));
}

}  // namespace limpet
