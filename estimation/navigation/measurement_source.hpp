// SPDX-License-Identifier: MIT
// The seam for sensors. One is a file in estimation/sources and a test.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "estimation/navigation/motion_readings.hpp"
#include "estimation/smoothing/term.hpp"
#include "limpet/core/message.hpp"

namespace mrpt::obs {
class CObservation;
}

namespace limpet {

/// Three slow errors of a source, estimated with the track: what is known of each beforehand
/// (1-sigma, zero mean), and what states.csv calls it, with its unit.
struct SourceErrors {
  std::vector<std::string> names;
  Eigen::Vector3d sigma = Eigen::Vector3d::Ones();
};

/// An echo of the seabed straight below the vehicle, along the body's z axis.
struct Sounding {
  Eigen::Vector3d p_BS = Eigen::Vector3d::Zero();  ///< of the transducer [m]
  double range = 0.0;                              ///< from there [m]
};

/// A sensor: mail becomes an observation, which can be recorded and replayed, and an observation a
/// term of the smoother. When it comes into the chain, whether it can be true, and what became of
/// it is the chain's business (AidingSources).
class MeasurementSource {
 public:
  virtual ~MeasurementSource() = default;

  /// The variable that it hears.
  [[nodiscard]] virtual std::string variable() const = 0;
  /// What the variable's value, measured at `t` [s], is; nothing if it makes no sense.
  [[nodiscard]] virtual std::shared_ptr<mrpt::obs::CObservation> Observe(
      double t, const Value& value) const = 0;
  /// Nothing: the source has no errors but noise.
  [[nodiscard]] virtual std::optional<SourceErrors> Errors() const { return std::nullopt; }
  /// What an observation says of the pose at its time: Term::OnPose, or Term::OnObservation with
  /// the slot of the source's slow errors. Nothing: it does not count (too soon after the last one,
  /// out of range).
  [[nodiscard]] virtual std::optional<Term> Measure(const mrpt::obs::CObservation& seen,
                                                    int errors) = 0;
  /// What it says of the seabed, which is where the altitude comes from while the DVL gives none.
  /// Nothing, of most.
  [[nodiscard]] virtual std::optional<Sounding> SeabedOf(
      const mrpt::obs::CObservation& /*seen*/) const {
    return std::nullopt;
  }
  /// True for one without which a vehicle is known well enough: nobody may write its variable.
  [[nodiscard]] virtual bool is_dispensable() const { return false; }
  /// True for one that says where the vehicle is: dead reckoning begins anew.
  [[nodiscard]] virtual bool is_fix() const { return false; }
};

/// A sensor that dead reckoning stands on. What it reads makes the chain that terms are upon, and
/// is used as soon as it comes: what of it can be true, Navigator decides.
class MotionSensor : public MeasurementSource {
 public:
  /// What an observation of this sensor's reads; nothing of one that it cannot have made.
  [[nodiscard]] virtual std::optional<MotionReading> ReadingOf(
      const mrpt::obs::CObservation& seen) const = 0;
  /// What the variable's value, measured at `t` [s], reads; nothing if it makes no sense.
  [[nodiscard]] std::optional<MotionReading> Read(double t, const Value& value) const;
  [[nodiscard]] std::optional<Term> Measure(const mrpt::obs::CObservation& /*seen*/,
                                            int /*errors*/) final {
    return std::nullopt;
  }
};

}  // namespace limpet
