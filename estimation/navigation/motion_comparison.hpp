// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <Eigen/Core>

#include "limpet/core/units.hpp"

namespace limpet {

/// What two sensors say of the same motion, stretch of time by stretch: how many times as far the
/// second one has it go as the first, along the first one's way and across. The median over the
/// last stretches counts, so that a glitch tells nothing, nor a phase of errors shorter than half
/// of them.
class MotionComparison {
 public:
  static constexpr std::size_t kMost = 9;
  struct Params {
    Seconds stretch{10.0};
    /// Way of the first sensor in a stretch that tells something: well beyond what noise of either
    /// makes of it. In the unit of the ways.
    double least = 1.0;
    /// Nothing said for longer: it begins anew.
    Seconds longest_pause{1.5};
    std::size_t stretches = kMost;  ///< that a ratio takes, an odd number
    std::size_t beside = 1;         ///< so far from the median low and high are
  };

  /// REQUIRES: 3 to kMost stretches, `beside` within them.
  explicit MotionComparison(const Params& params);

  /// Both went on by so much up to `t` [s], in one unit and frame.
  void Add(double t, const Eigen::Vector2d& way, const Eigen::Vector2d& other);
  /// Along and across (starboard is positive, of axes that point ahead and to starboard), axis by
  /// axis; (1, 0) of sensors that agree.
  struct Ratio {
    Eigen::Vector2d median_H = Eigen::Vector2d::Zero();
    /// Those `beside` below and above: what goes one way and the other by turns shows in them.
    Eigen::Vector2d low_H = Eigen::Vector2d::Zero(), high_H = Eigen::Vector2d::Zero();
  };
  /// Nothing before there were enough stretches with a way.
  [[nodiscard]] std::optional<Ratio> ratio() const;

 private:
  struct Stretch {
    double from = 0.0, to = 0.0;  ///< [s]
    Eigen::Vector2d way = Eigen::Vector2d::Zero(), other = Eigen::Vector2d::Zero();
  };

  Params params_;
  std::optional<Stretch> now_;
  std::array<Eigen::Vector2d, kMost> ratios_;
  std::size_t count_ = 0;  ///< of stretches that told something
};

}  // namespace limpet
