// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "estimation/mapping/beam_evidence.hpp"
#include "estimation/mapping/depth_map.hpp"
#include "estimation/mapping/dvl_beams.hpp"
#include "limpet/core/units.hpp"
#include "limpet/topics/navigation.hpp"

namespace limpet {

/// A session's DVL pings, laid into space where the track now has them. Each ping is kept, 112
/// bytes (19 MB for six hours at 8 Hz), so that it can be taken back and laid elsewhere when the
/// smoother moves the way behind: the map is then, voxel for voxel, what the corrected track would
/// have made.
class BeamMap {
 public:
  /// Pings that have moved less than this since they were laid stay [m].
  static constexpr double kStays = 0.01;
  /// Work that fits into one tick: about 400 pings laid again, two to three milliseconds.
  static constexpr int kWorkPerTick = 40'000;

  /// `most_held`: what voxels may take, as BeamEvidence has it.
  explicit BeamMap(Meters resolution, const DvlBeams& dvl = {},
                   std::size_t most_held = BeamEvidence::kMostHeld);

  /// Lays the ping of time `t` [s], not before the last one's, whose beams end at `ends`
  /// (BeamEnds). Returns how many of them it could hold: those not too far from the origin.
  int Add(double t, const PosedBeams& ping, const std::vector<BeamEnd>& ends);
  /// The track behind has moved. Takes effect with Settle, for the pings that there are now.
  void Shift(const TrackShift& shift);
  /// Moves pings as the shifts say, oldest shift first; at most about `work` units, of which one
  /// looks at a ping and a hundred lay one again. True if nothing is left to do.
  bool Settle(int work = kWorkPerTick);
  void SettleAll();
  [[nodiscard]] bool is_settled() const { return sweeps_.empty(); }
  /// Ends on the seabed of a ping, as laid; pings count from 0 in the order in which they came.
  [[nodiscard]] std::vector<Eigen::Vector3d> SeabedEnds(std::size_t ping) const;

  /// What beams say of a voxel; zeros where none has been.
  [[nodiscard]] VoxelCounts At(const VoxelKey& key) const;
  /// All voxels of a tile that beams have been in, in no order.
  void ForEachKnown(const TileKey& tile, const BeamEvidence::VoxelVisitor& visit) const;
  /// Those that beams have been in, by key.
  [[nodiscard]] std::vector<TileKey> Tiles() const { return evidence_.Tiles(); }
  /// Those that are other than when this was last called, by key.
  [[nodiscard]] std::vector<TileKey> TakeChanged() { return evidence_.TakeChanged(); }
  [[nodiscard]] double resolution() const { return evidence_.resolution(); }
  /// Size of the voxels that are in memory [bytes].
  [[nodiscard]] std::size_t held_bytes() const { return evidence_.bytes(); }
  /// Depths of the seabed, by columns as wide as a voxel.
  [[nodiscard]] const DepthMap& depths() const { return depths_; }
  [[nodiscard]] std::size_t pings() const { return pings_.size(); }

 private:
  struct Ping {
    double t = 0.0;
    Pose X_WD;  ///< as laid
    std::array<double, 4> ranges{};
    std::array<float, 4> owed{};  ///< what it has moved since: north, east, down [m], yaw [rad]
    std::uint8_t used = 0;        ///< bit by beam: laid
    std::uint8_t seabed = 0;      ///< bit by beam: its end is the seabed
    [[nodiscard]] bool uses(std::size_t beam) const { return (used >> beam & 1U) != 0; }
    [[nodiscard]] bool sees_seabed(std::size_t beam) const { return (seabed >> beam & 1U) != 0; }
  };
  /// A shift on its way through the pings.
  struct Sweep {
    TrackShift shift;
    std::size_t next = 0, end = 0;
  };
  enum class Laying { kAdd, kTakeBack };

  /// Which pings have been laid in a tile; some may have left it since.
  struct TilePings {
    std::vector<std::uint32_t> pings;  ///< some twice
    std::size_t each_once = 0;         ///< so many were left when they were last gone through
  };

  [[nodiscard]] Eigen::Vector3d EndOf(const Ping& ping, const Eigen::Matrix3d& R_WD,
                                      std::size_t beam) const;
  /// Its beams' ends that can be laid, with their numbers.
  template <class Visit>
  void ForEachBeam(const Ping& ping, const Visit& visit) const;
  /// `extent_W`: of all its beams as laid.
  void NoteTiles(std::uint32_t ping, const Eigen::AlignedBox3d& extent_W);
  /// Lays a tile again that has been dropped.
  void Hold(const TileKey& tile) const;
  void NoteDepthSigma(const PosedBeams& ping);
  void Lay(std::uint32_t number, const Ping& ping, Laying laying);
  /// Returns the work it took.
  int Move(std::uint32_t number, const TrackShift& shift);
  [[nodiscard]] double Owed(const Ping& ping) const;

  std::array<Eigen::Vector3d, 4> directions_;
  double reach_;                   ///< horizontal, of a beam of one metre [m]
  mutable BeamEvidence evidence_;  ///< what is dropped of it comes back when it is read
  std::map<TileKey, TilePings> tile_pings_;
  DepthMap depths_;
  double down_variance_ = 0.0;  ///< of depth: sum over the pings that say one [m^2]
  int with_variance_ = 0;
  std::deque<Ping> pings_;
  std::deque<Sweep> sweeps_;
};

}  // namespace limpet
