// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limpet/core/units.hpp"

namespace limpet {

/// What fixes are off over what they state, learnt from the fixes of a session. Their error is
/// noise and a Gauss-Markov process. How fast it wanders shows within one stay at the surface, how
/// far it goes between stays; how long it stays the same is known to a factor of two, seldom worse.
/// What the receiver states is a prior only: mostly right within such a factor, and now and then
/// not at all. Hypotheses of sigma, noise and time are weighed by all that came.
class FixErrorBelief {
 public:
  /// `correlation`: for how long the error stays about the same.
  explicit FixErrorBelief(Seconds correlation);

  /// How far the first fix is from where dead reckoning and all else has the vehicle.
  struct Start {
    Eigen::Vector2d off_W = Eigen::Vector2d::Zero();  ///< fix less that [m]
    double variance = 0.0;                            ///< of each axis [m^2]
  };
  /// The next stay; nothing: nothing else tells where the vehicle is.
  void BeginStay(const std::optional<Start>& start);
  /// The fixes of this stay are others: what they said is forgotten.
  void RestartStay();

  struct Fix {
    double t = 0.0;                                   ///< [s]
    Eigen::Vector2d off_W = Eigen::Vector2d::Zero();  ///< less dead reckoning [m]
    double sd = 0.0;                                  ///< stated [m]
    double drift = 0.0;  ///< variance of dead reckoning since the last [m^2]
  };
  void Add(const Fix& fix);

  /// Sigma of what wanders over what is stated of all of it: as stated, or worse, less the noise.
  [[nodiscard]] double Scale() const;
  /// Mean and 1-sigma of the whole sigma over what is stated.
  struct Ratio {
    double mean = 1.0, sd = 0.0;
    /// Beyond the factor of two by which any receiver may be worse than it states.
    [[nodiscard]] bool is_too_large() const { return mean > 2.0; }
  };
  [[nodiscard]] Ratio ratio() const;

 private:
  /// One set of what is not known, and what dead reckoning and wandering are off if it is true.
  struct Hypothesis {
    double scale = 1.0, noise = 0.1;  ///< of the whole sigma, of the noise; over what is stated
    double correlation = 120.0;       ///< [s]
    double log_before = 0.0;          ///< of its weight, when the stay began
    double log_weight = 0.0;
    Eigen::Vector2d wander_W = Eigen::Vector2d::Zero(), place_W = Eigen::Vector2d::Zero();  // [m]
    double wander_variance = 0.0, between = 0.0, place_variance = 0.0;                      // [m^2]

    /// Variance of what wanders over the square of what is stated.
    [[nodiscard]] double WanderShare() const;
  };
  void Begin(Hypothesis& hypothesis, const Fix& fix) const;
  void Use(Hypothesis& hypothesis, const Fix& fix, double seconds) const;
  template <typename Value>
  [[nodiscard]] double Mean(const Value& value) const;

  std::vector<Hypothesis> hypotheses_;
  std::optional<Start> start_;
  std::optional<double> last_t_;  ///< of this stay's fixes
};

}  // namespace limpet
