// SPDX-License-Identifier: MIT
// Slant range to an acoustic beacon at a known place, e.g. a transponder on the seabed.
#include <cmath>

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationBeaconRanges.h>

#include "estimation/navigation/source_registry.hpp"
#include "estimation/smoothing/factors/beacon_factor.hpp"

namespace limpet {
namespace {

class BeaconRange final : public MeasurementSource {
 public:
  struct Params {
    std::string variable = "BEACON_RANGE";
    Eigen::Vector3d beacon = Eigen::Vector3d::Zero(), transducer = Eigen::Vector3d::Zero();
    Meters sigma{0.5}, at_sigma{1.0}, greatest{1000.0};
    template <class Visitor>
    void Describe(Visitor& visit) {
      using namespace literals;
      visit("variable", variable, "Says the slant range, a number [m]");
      visit.Required("at_m", beacon, "m", "The beacon: north, east, down");
      visit("at_sigma_m", at_sigma,
            "1-sigma of each axis of at_m: where the beacon really is, is estimated with the track",
            InRange(0.01_m, 1000.0_m));
      visit("transducer_m", transducer, "m", "The vehicle's own: forward, starboard, down",
            InRange(-10.0, 10.0));
      visit("sigma_m", sigma, "1-sigma of a range, sound speed included",
            InRange(0.001_m, 100.0_m));
      visit("greatest_m", greatest, "What is further is an echo", InRange(1.0_m, 20000.0_m));
    }
  };
  explicit BeaconRange(const Params& params) : params_(params) {}

  [[nodiscard]] std::string variable() const override { return params_.variable; }

  [[nodiscard]] mrpt::obs::CObservation::Ptr Observe(double t, const Value& value) const override {
    const auto* range = std::get_if<double>(&value);
    if (range == nullptr || !std::isfinite(*range) || *range <= 0.0) return nullptr;
    auto seen = mrpt::obs::CObservationBeaconRanges::Create();
    seen->timestamp = mrpt::Clock::fromDouble(t);
    seen->stdError = static_cast<float>(params_.sigma.value());
    seen->maxSensorDistance = static_cast<float>(params_.greatest.value());
    seen->sensedData.emplace_back();
    seen->sensedData.back().sensedDistance = static_cast<float>(*range);
    const Eigen::Vector3d& p = params_.transducer;
    seen->sensedData.back().sensorLocationOnRobot = mrpt::poses::CPoint3D(p.x(), p.y(), p.z());
    return seen;
  }

  [[nodiscard]] std::optional<SourceErrors> Errors() const override {
    return SourceErrors{.names = {"beacon_off_north_m", "beacon_off_east_m", "beacon_off_down_m"},
                        .sigma = Eigen::Vector3d::Constant(params_.at_sigma.value())};
  }

  [[nodiscard]] std::optional<Term> Measure(const mrpt::obs::CObservation& seen,
                                            int errors) override {
    const auto& ranges = dynamic_cast<const mrpt::obs::CObservationBeaconRanges&>(seen);
    const auto& one = ranges.sensedData.front();
    if (one.sensedDistance > ranges.maxSensorDistance) return std::nullopt;
    const auto& place = one.sensorLocationOnRobot;
    const Meters measured(one.sensedDistance), sigma(ranges.stdError);
    return Term::OnObservation(
        BeaconFactor(params_.beacon, {place.x(), place.y(), place.z()}, measured, sigma), errors);
  }

 private:
  Params params_;
};

LIMPET_REGISTER_SOURCE(BeaconRange, "beacon_range");

}  // namespace
}  // namespace limpet
