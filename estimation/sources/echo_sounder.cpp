// SPDX-License-Identifier: MIT
// How far the seabed is below, of an altimeter or echo sounder that looks along the body's z axis.
#include <cmath>

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationRange.h>

#include "estimation/navigation/source_registry.hpp"

namespace limpet {
namespace {

class EchoSounder final : public MeasurementSource {
 public:
  struct Params {
    std::string variable = "ECHO_SOUNDER";
    Eigen::Vector3d transducer = Eigen::Vector3d::Zero();
    Meters least{0.2}, greatest{50.0};
    template <class Visitor>
    void Describe(Visitor& visit) {
      using namespace literals;
      visit("variable", variable, "Says the range to the seabed, a number [m]");
      visit("transducer_m", transducer, "m", "Where it sits: forward, starboard, down",
            InRange(-10.0, 10.0));
      visit("least_m", least, "What is nearer is its own ringing", InRange(0.0_m, 10.0_m));
      visit("greatest_m", greatest, "What is further is no echo", InRange(1.0_m, 12000.0_m));
    }
  };
  explicit EchoSounder(const Params& params) : params_(params) {}

  [[nodiscard]] std::string variable() const override { return params_.variable; }

  [[nodiscard]] mrpt::obs::CObservation::Ptr Observe(double t, const Value& value) const override {
    const auto* range = std::get_if<double>(&value);
    if (range == nullptr || !std::isfinite(*range) || *range < 0.0) return nullptr;
    auto seen = mrpt::obs::CObservationRange::Create();
    seen->timestamp = mrpt::Clock::fromDouble(t);
    seen->minSensorDistance = static_cast<float>(params_.least.value());
    seen->maxSensorDistance = static_cast<float>(params_.greatest.value());
    seen->sensedData.emplace_back();
    seen->sensedData.back().sensedDistance = static_cast<float>(*range);
    const Eigen::Vector3d& p = params_.transducer;
    // MRPT's ranges lie along the sensor's x axis, which here looks down.
    seen->sensedData.back().sensorPose =
        mrpt::math::TPose3D(p.x(), p.y(), p.z(), 0.0, -0.5 * M_PI, 0.0);
    return seen;
  }

  [[nodiscard]] std::optional<Sounding> SeabedOf(
      const mrpt::obs::CObservation& seen) const override {
    const auto& ranges = dynamic_cast<const mrpt::obs::CObservationRange&>(seen);
    const auto& one = ranges.sensedData.front();
    const bool is_echo = one.sensedDistance >= ranges.minSensorDistance &&
                         one.sensedDistance <= ranges.maxSensorDistance;
    if (!is_echo) return std::nullopt;
    const auto& place = one.sensorPose;
    return Sounding{.p_BS = {place.x, place.y, place.z}, .range = one.sensedDistance};
  }

  /// A range to ground that nobody knows says nothing of the pose.
  [[nodiscard]] std::optional<Term> Measure(const mrpt::obs::CObservation& /*seen*/,
                                            int /*errors*/) override {
    return std::nullopt;
  }

 private:
  Params params_;
};

LIMPET_REGISTER_SOURCE(EchoSounder, "echo_sounder");

}  // namespace
}  // namespace limpet
