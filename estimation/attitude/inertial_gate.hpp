// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "estimation/attitude/inertial_input.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// Changes from one sample to the next that no vehicle makes. An underwater vehicle speeds its turn
/// up by a few rad/s^2 and itself by a few m/s^2; noise, waves and thrusters that shake it come on
/// top.
struct InertialGateParams {
  Radians rate_jump{0.5};       ///< of a rate that always passes [rad/s, as an angle per second]
  Radians rate_growth{3.0};     ///< further allowance per second since [rad/s^2, likewise]
  double force_jump = 12.0;     ///< of the specific force [m/s^2]
  double force_growth = 20.0;   ///< further allowance per second since [m/s^3]
  Radians heading_jump{0.35};   ///< beyond what the yaw rate explains
  Radians heading_growth{0.5};  ///< further allowance per second since
  Seconds longest_growth{1.0};  ///< no older sample allows more
  /// Samples that agree so long among themselves are right. Shorter than what counts as a gap.
  Seconds believed_after{0.3};
};

/// Sorts out inertial samples that cannot be the vehicle's: a glitch of the sensor or of its line
/// leaps away from both of the last good samples, of which one may have been a small one. Samples
/// that leap likewise and agree with one another for `believed_after` are the truth: what was
/// believed before was not, or the vehicle was thrown about. Samples that agree with nothing are
/// never believed. The heading, which has a sensor of its own, is judged by itself.
class InertialGate {
 public:
  enum class Verdict : std::uint8_t {
    kGood,
    kRefused,   ///< an outlier
    kBelieved,  ///< what was refused is the truth
  };

  explicit InertialGate(const InertialGateParams& params = {}) : params_(params) {}

  /// Verdict on a sample's rates and forces. REQUIRES: finite, later than the sample before.
  [[nodiscard]] Verdict JudgeMotion(const InertialInput& sample);
  /// Verdict on a sample's heading. REQUIRES: finite, later than the sample before, its motion no
  /// outlier.
  [[nodiscard]] Verdict JudgeHeading(const InertialInput& sample);
  /// What comes next has nothing to agree with: nobody knows what happened meanwhile.
  void Forget() { motion_ = heading_ = {}; }

 private:
  struct Beliefs {
    std::optional<InertialInput> good{};    ///< the last one
    std::optional<InertialInput> before{};  ///< the one before it
    std::optional<InertialInput> other{};   ///< newest of those that leapt away and agree
    double other_since = 0.0;               ///< [s]
  };
  template <class Agrees>
  Verdict Judge(const InertialInput& sample, Beliefs& beliefs, const Agrees& agrees) const;
  [[nodiscard]] double AgeOf(const InertialInput& former, const InertialInput& sample) const;

  InertialGateParams params_;
  Beliefs motion_, heading_;
};

}  // namespace limpet
