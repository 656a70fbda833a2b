// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "limpet/core/expected.hpp"

namespace limpet {

/// The seabed in one column, as the beams that ended there have it.
struct DepthColumn {
  double north = 0.0, east = 0.0;  ///< middle [m]
  double down = 0.0;               ///< NED [m]
  double sigma = 0.0;              ///< of `down`, beside what the whole session is off by [m]
  std::uint32_t beams = 0;
};

/// Depth of the seabed by columns, as sums over beams' ends to the millimetre: an end can be taken
/// back exactly, in any order.
///
/// Sigma. How far beams of a column scatter about their mean is learnt from all columns together,
/// and from the column itself as it gets beams of its own: range noise, roughness and waves are all
/// in it, whatever the data sheet says. It shrinks with the number of beams, down to what beams of
/// one pass have in common (`kShared`: attitude, depth sensor).
class DepthMap {
 public:
  /// What more beams of the same pass do not average out, 1-sigma [m].
  static constexpr double kShared = 0.01;

  explicit DepthMap(double cell_m) : cell_m_(cell_m) {}

  /// An end of a beam on the seabed; left out if it is no place: 1000 km away, or no number.
  void Add(const Eigen::Vector3d& p_W) { Sum(p_W, 1); }
  /// Undoes one Add of the very same point.
  void TakeBack(const Eigen::Vector3d& p_W) { Sum(p_W, -1); }
  /// How well the vehicle knew its depth meanwhile, 1-sigma [m]: all columns may be off by it.
  void SetZeroSigma(double sigma) { zero_sigma_ = sigma; }

  /// Mean depth of the column that holds a place [m]; nothing where no beam ended.
  [[nodiscard]] std::optional<double> DownAt(const Eigen::Vector2d& p_W) const;
  /// All columns that a beam ended in, sorted by north, then by east.
  [[nodiscard]] std::vector<DepthColumn> Columns() const;
  [[nodiscard]] double cell_m() const { return cell_m_; }
  [[nodiscard]] double zero_sigma() const { return zero_sigma_; }

  /// Text: `cell_m=,zero_sigma_m=`, the names of the fields, then a line per column: its index
  /// north and east (floor of metres over `cell_m`), beams, and over these the sums of their depth
  /// [mm] and of its square [mm^2].
  [[nodiscard]] std::string Serialize() const;
  [[nodiscard]] static Expected<DepthMap> Parse(std::string_view text);

 private:
  using Key = std::array<std::int32_t, 2>;
  struct KeyHash {
    std::size_t operator()(const Key& key) const;
  };
  struct Sums {
    std::int64_t beams = 0, down_mm = 0;
    std::uint64_t square_mm2 = 0;  ///< room for half a million beams in 6 km of depth
    /// Sum of the squares of what the beams are off from their mean depth [mm^2].
    [[nodiscard]] double scatter() const;
  };

  void Sum(const Eigen::Vector3d& p_W, std::int64_t sign);
  [[nodiscard]] std::vector<std::pair<Key, Sums>> Sorted() const;

  double cell_m_;
  double zero_sigma_ = 0.0;
  std::unordered_map<Key, Sums, KeyHash> columns_;
};

}  // namespace limpet
