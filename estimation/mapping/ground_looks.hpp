// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "estimation/change/look_log.hpp"
#include "estimation/mapping/semantic_map.hpp"
#include "limpet/objects/frame.hpp"
#include "limpet/survey/look.hpp"

namespace limpet {

/// What images say of the ground where they show nothing: of each column with a known seabed, how
/// surely it is no object's. Only looks count in which an object there would more likely than not
/// have been seen: inside the image, near enough in this water, and with nothing in front. Looks of
/// one pass are one witness, of whom the best one speaks.
class GroundLooks {
 public:
  /// Columns looked at in one tick, a millisecond or two.
  static constexpr int kWorkPerTick = 1000;

  GroundLooks(const LookModel& model, const LookParams& looks) : model_(model), looks_(looks) {}

  /// Takes another model of what is seen: in other water, all looks are judged again.
  void SetModel(const LookModel& model);
  /// The frames have moved: they are gone through again, beside what is known meanwhile.
  void BeginAnew() { is_stale_ = true; }
  /// Goes on through `frames`, a session's in order of time, as far as `work` columns go. True if
  /// nothing is left to do. Waits for the map's beams to be where they belong.
  bool Settle(const std::vector<ObservedFrame>& frames, const SemanticMap& map,
              int work = kWorkPerTick);
  /// ln P_a / (1 - P_a) of ground in the voxel's column, zero or less.
  [[nodiscard]] float LogOdds(const VoxelKey& key) const;
  /// Tiles of which other odds are said than when this was last called.
  [[nodiscard]] std::set<TileKey> TakeChanged() { return std::exchange(known_.changed, {}); }

 private:
  struct Column {
    double passes = 0.0;  ///< log-odds of the passes before
    double pass = 0.0;    ///< of the best look of the latest one
    double last = 0.0;    ///< its time [s]
  };
  /// A tile's, by their place in it.
  using Columns = std::vector<Column>;

  /// What came of going through the frames, so far.
  struct Passage {
    std::map<TileKey, Columns> tiles;
    std::set<TileKey> changed;
    std::size_t next_frame = 0;
    std::optional<Pose> last_look;
  };

  /// What was gone through anew is what is known from now on.
  void TakeOver();
  [[nodiscard]] bool IsNewLook(const ObservedFrame& frame, const Passage& passage) const;
  /// Returns the work that is left; none if the frames are not all gone through.
  int GoOn(Passage& passage, const std::vector<ObservedFrame>& frames, const SemanticMap& map,
           int work) const;
  /// Returns the work it took.
  int Look(const ObservedFrame& frame, const SemanticMap& map, Passage& passage) const;
  /// What the frame says of an object that stands on a place; nothing if that is no look, or if a
  /// box is there.
  [[nodiscard]] std::optional<double> MissAt(const ObservedFrame& frame, const SemanticMap& map,
                                             const Eigen::Vector3d& ground_W) const;
  [[nodiscard]] bool IsInSight(const ObservedFrame& frame, const SemanticMap& map,
                               const Eigen::Vector3d& ground_W) const;

  LookModel model_;
  LookParams looks_;
  Passage known_;
  std::optional<Passage> anew_;
  bool is_stale_ = false;  ///< frames moved since `known_`, or `anew_`, was begun
};

}  // namespace limpet
