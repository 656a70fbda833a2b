// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "estimation/navigation/motion_comparison.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// Two sensors that cannot both be right, and what they say.
struct Disagreement {
  std::string_view what;  ///< of SensorAgreement::kMotions
  std::string text;
};

/// Whether sensors that measure the same motion agree on its direction and size, roughly: a sign,
/// an axis or a unit that is wrong in all that a sensor says is consistent, so no gate refuses it.
/// - TURN: the compass's heading turns as far as the gyro's yaw.
/// - DIVE: depth grows by as much as the DVL sinks.
/// - WAY: at the surface fixes go where the DVL goes, by the heading.
/// - SEE: boxes move through the images as the vehicle goes over what they show (BoxMotion).
/// - DRIVE: the DVL goes where the thrusters push; a current turns that by less than a wrong axis.
class SensorAgreement {
 public:
  static constexpr std::string_view kTurn = "TURN", kDive = "DIVE", kWay = "WAY", kSee = "SEE",
                                    kDrive = "DRIVE";
  static constexpr std::array kMotions = {kTurn, kDive, kWay, kSee, kDrive};

  /// 1-sigma of the depths of a second [m].
  explicit SensorAgreement(Meters depth_sigma);

  /// Yaw of the gyro and heading of the compass [rad].
  struct Headings {
    double gyro = 0.0, compass = 0.0;
  };
  void AddHeadings(double t, const Headings& headings);
  /// Downwards velocity of the DVL [m/s], and depth about then [m].
  struct Dive {
    double v_down = 0.0, depth = 0.0;
  };
  void AddDive(double t, const Dive& dive);
  /// A fix, with its 1-sigma, and where the DVL's track has the vehicle then; north and east of the
  /// heading, from anywhere [m].
  void AddFix(double t, const Eigen::Vector2d& p_W, double sd, const Eigen::Vector2d& track_D);
  /// Speed through the water that the thrusters make, and velocity over ground, both ahead and to
  /// starboard in the levelled heading frame [m/s].
  void AddDrive(double t, const Eigen::Vector2d& driven_H, const Eigen::Vector2d& v_H);

  /// Disagreements found, each as of the last minutes in which it showed.
  [[nodiscard]] std::vector<Disagreement> Found() const;

 private:
  struct FixSample {
    Eigen::Vector2d p_W, track_D;
  };
  MotionComparison turn_, dive_, way_, drive_;
  // The last samples, for the increment to the next.
  std::optional<Headings> last_headings_;
  std::optional<std::pair<double, Dive>> last_dive_;  ///< with its time
  std::optional<FixSample> last_fix_;
  std::optional<double> last_drive_t_;
};

}  // namespace limpet
