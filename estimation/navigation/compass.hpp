// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include <Eigen/Core>

#include "estimation/smoothing/smoother.hpp"
#include "limpet/core/long_ago.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

struct CompassParams {
  Radians sigma{0.0};  ///< believed of its constant error and of its deviation; 0: no compass
  Radians noise = Radians::FromTextUnit(0.6);  ///< of one heading, of which `period` brings another
  Seconds period{5.0};
};

/// The magnetic heading, while the gyro carries yaw: its error is the same over a session but for
/// the deviation that goes with the heading, the compass adjuster's A, B and C. A is what turns all
/// of the map, and nothing but fixes far apart or a former session measures it. B and C show as the
/// vehicle turns, and tell what to think of A: a compass that swings by degrees is not believed to
/// be right on average. `smoother` must outlive it.
class Compass {
 public:
  /// Deviation in the order of the adjuster's letters: constant, with sine and with cosine of the
  /// heading.
  struct Deviation {
    Eigen::Vector3d value = Eigen::Vector3d::Zero();  ///< [rad]
    Eigen::Vector3d sd = Eigen::Vector3d::Zero();
    double believed_sd = 0.0;  ///< of each, before it was seen
    /// Larger than believed, beyond doubt.
    bool is_too_large = false;
  };

  Compass(const CompassParams& params, Smoother& smoother)
      : params_(params), smoother_(&smoother) {}

  [[nodiscard]] bool is_in_use() const { return params_.sigma > Radians(0.0); }
  /// The smoother has its first pose. REQUIRES: is_in_use().
  void Begin();
  /// A heading at the time [s] of `node`; most of them are passed over.
  void Use(double t, Radians heading, int node);
  /// Nothing before Begin.
  [[nodiscard]] std::optional<int> slot() const { return slot_; }
  /// Nothing before Begin.
  [[nodiscard]] std::optional<Deviation> deviation() const;

 private:
  /// What the errors seen so far tell of their kind.
  void Learn();

  CompassParams params_;
  Smoother* smoother_;
  std::optional<int> slot_;
  std::shared_ptr<double> sigma_;  ///< the priors read it
  double used_t_ = kLongAgo;
  int used_ = 0;
};

}  // namespace limpet
