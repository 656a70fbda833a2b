// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include "limpet/core/units.hpp"

namespace limpet {

struct VelocityGateParams {
  MetersPerSecond fastest{30.0};  ///< that anything goes under water, of its own
  MetersPerSecond jump{0.15};     ///< change against the last accepted velocity that always passes
  double growth_mps2 = 0.15;      ///< further allowance per second since then [m/s^2]
  Seconds longest_growth{1.0};    ///< no older velocity allows more
  Seconds longest_pause{0.5};     ///< between false velocities that are one
  Seconds proven{1.0};            ///< velocities that agree so long stand against others
  Seconds dropout{1.0};           ///< without a good one, in which a vehicle may change its way
  Seconds longest_burst{12.0};  ///< false velocities that agree with one another do not last longer
  double felt_share = 0.3;      ///< of a change: less than this was none, says the accelerometer
  /// False velocities of which the accelerometer has felt no beginning do not last longer.
  Seconds longest_denied{60.0};
};

/// What else tells of the velocity [m/s].
struct VelocityEvidence {
  std::optional<Eigen::Vector3d> predicted_B{};  ///< that a dropout is bridged with
  /// That the accelerometer makes of the last one accepted, while that is good for anything.
  std::optional<Eigen::Vector3d> felt_B{};
};

/// Sorts out bottom-track velocity that cannot be the vehicle's: a sample passes when it differs
/// from one of the last two accepted ones by no more than an allowance that grows with its age, or
/// from what is predicted or felt by as much. Any other is false, however many samples in a row say
/// so, until they have lasted too long for that: much longer where the accelerometer felt nothing
/// when they began; sooner after a dropout, in which the vehicle may have changed its way, and as
/// soon again while that is new: but then what was believed before stays an alternative. Samples
/// that tell of another sink rate only are believed at the second: a vehicle begins to dive at
/// once. Before anything is proven a second sample that agrees is enough: a wrong first one must
/// not lock the gate.
class VelocityGate {
 public:
  enum class Verdict : std::uint8_t {
    kGood,
    kRefused,    ///< an outlier
    kContested,  ///< goes on as the refused one before it: one false velocity, or a new truth
    kBelieved,   ///< what was contested, or an alternative, is the truth, and was since it began
  };

  explicit VelocityGate(const VelocityGateParams& params) : params_(params) {}

  /// Verdict on the velocity `v_B` [m/s], measured at `t` [s].
  [[nodiscard]] Verdict Judge(double t, const Eigen::Vector3d& v_B,
                              const VelocityEvidence& evidence = {}) {
    if (!(v_B.norm() <= params_.fastest.value())) return Verdict::kRefused;
    const Sample sample{t, v_B};
    if (!last_) return Accept(sample, Verdict::kGood);
    if (t - good_since_ > params_.longest_burst.value()) alternative_.reset();
    if (alternative_ && !Agrees(sample, *last_) && Agrees(sample, *alternative_)) {
      alternative_.reset();
      return Accept(sample, Verdict::kBelieved);
    }
    const bool goes_on = refused_ && Agrees(sample, *refused_) && IsNearer(sample, *refused_);
    const bool is_felt = IsAs(evidence.felt_B, sample);
    if (is_felt || (!goes_on && (IsAsLately(sample) || IsAs(evidence.predicted_B, sample)))) {
      return Accept(sample, Verdict::kGood);
    }
    if (!goes_on) {
      if (!IsContest(t)) Begin(sample, evidence);
      return Verdict::kRefused;
    }
    refused_ = sample;
    return JudgeContest(sample);
  }

  /// The velocity [m/s] that the vehicle has if the one believed now is false.
  [[nodiscard]] std::optional<Eigen::Vector3d> alternative_B() const {
    return alternative_ ? std::optional(alternative_->v_B) : std::nullopt;
  }

 private:
  struct Sample {
    double t;
    Eigen::Vector3d v_B;
  };
  /// Verdict on a sample that goes on as the refused ones did.
  Verdict JudgeContest(const Sample& sample) {
    const bool is_proven =
        last_->t - good_since_ >= params_.proven.value() && !AgreesLevel(sample, *last_);
    const bool is_open = IsOpen();
    const Seconds longest = is_open      ? params_.proven
                            : is_denied_ ? params_.longest_denied
                                         : params_.longest_burst;
    if (is_proven && sample.t - refused_since_ < longest.value()) return Verdict::kContested;
    if (HadDropout()) open_since_ = refused_since_;
    alternative_ = is_proven && is_open ? last_ : std::nullopt;
    good_since_ = refused_since_;
    return Accept(sample, is_proven ? Verdict::kBelieved : Verdict::kGood);
  }
  [[nodiscard]] bool HadDropout() const {
    return refused_since_ - last_->t > params_.dropout.value();
  }
  /// Nothing tells yet which of two velocities is the vehicle's: a dropout has ended, and what is
  /// believed since, nobody felt begin. Then the accelerometer denies a change back as well.
  [[nodiscard]] bool IsOpen() const {
    return HadDropout() ||
           (open_since_ && refused_since_ - *open_since_ < params_.longest_burst.value());
  }
  Verdict Accept(const Sample& sample, Verdict verdict) {
    if (!last_) good_since_ = sample.t;
    before_last_ = verdict == Verdict::kGood ? last_ : std::nullopt;
    last_ = sample;
    refused_.reset();
    return verdict;
  }
  /// True if the sample is like one of the last two: one of them may have been an outlier that was
  /// allowed.
  [[nodiscard]] bool IsAsLately(const Sample& sample) const {
    const bool is_fresh =
        before_last_ && sample.t - before_last_->t <= params_.longest_growth.value();
    return Agrees(sample, *last_) || (is_fresh && Agrees(sample, *before_last_));
  }
  /// False velocities that go on, though not in this sample: it is a mere outlier among them.
  [[nodiscard]] bool IsContest(double t) const {
    return refused_ && refused_->t > refused_since_ &&
           t - refused_->t <= params_.longest_pause.value();
  }
  void Begin(const Sample& first, const VelocityEvidence& evidence) {
    refused_ = first;
    refused_since_ = first.t;
    const double claimed = (first.v_B - last_->v_B).norm();
    is_denied_ =
        evidence.felt_B && (*evidence.felt_B - last_->v_B).norm() < params_.felt_share * claimed;
  }
  /// True if the sample is nearer to `refused` than to the last good one, whose allowance has grown
  /// since.
  [[nodiscard]] bool IsNearer(const Sample& sample, const Sample& refused) const {
    return (sample.v_B - refused.v_B).squaredNorm() < (sample.v_B - last_->v_B).squaredNorm();
  }
  [[nodiscard]] bool IsAs(const std::optional<Eigen::Vector3d>& expected_B,
                          const Sample& sample) const {
    return expected_B && (sample.v_B - *expected_B).norm() <= params_.jump.value();
  }
  [[nodiscard]] bool Agrees(const Sample& a, const Sample& b) const {
    const double age = std::min(a.t - b.t, params_.longest_growth.value());
    return (a.v_B - b.v_B).norm() <= params_.jump.value() + params_.growth_mps2 * age;
  }
  /// A vehicle that begins to dive leaves its velocity ahead and abeam as it was.
  [[nodiscard]] bool AgreesLevel(const Sample& a, const Sample& b) const {
    return (a.v_B - b.v_B).head<2>().norm() <= params_.jump.value();
  }
  VelocityGateParams params_;
  std::optional<Sample> last_, before_last_, refused_, alternative_;
  double good_since_ = 0.0, refused_since_ = 0.0;  ///< [s]
  /// Since when what a dropout ended with has been believed without being as before or predicted.
  std::optional<double> open_since_;
  bool is_denied_ = false;  ///< what is refused, by the accelerometer
};

}  // namespace limpet
