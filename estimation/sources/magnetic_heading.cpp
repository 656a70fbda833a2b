// SPDX-License-Identifier: MIT
// The magnetic heading during the dive. Its deviation is estimated; so it holds the heading of a
// vehicle whose gyro drifts, and is not believed further than what its own iron leaves.
#include <cmath>

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationIMU.h>

#include "estimation/navigation/source_registry.hpp"
#include "estimation/smoothing/factors/compass_factor.hpp"
#include "limpet/core/long_ago.hpp"
#include "limpet/topics/sensors.hpp"

namespace limpet {
namespace {

class MagneticHeading final : public MeasurementSource {
 public:
  struct Params {
    Radians sigma = Radians::FromTextUnit(1.0), deviation = Radians::FromTextUnit(2.0);
    Seconds period{5.0};
    template <class Visitor>
    void Describe(Visitor& visit) {
      using namespace literals;
      visit("sigma_deg", sigma, "1-sigma of one heading, of which `period_s` brings another",
            InRange(0.01_deg, 45.0_deg));
      visit("deviation_deg", deviation,
            "1-sigma of the constant error and of each that goes with the heading",
            InRange(0.01_deg, 45.0_deg));
      visit("period_s", period, "Headings closer together err alike: one of them is used",
            InRange(0.1_s, 600.0_s));
    }
  };
  explicit MagneticHeading(const Params& params) : params_(params) {}

  [[nodiscard]] std::string variable() const override { return topics::kImuData.name; }

  [[nodiscard]] mrpt::obs::CObservation::Ptr Observe(double t, const Value& value) const override {
    const auto sample = TopicCodec<ImuSample>::Decode(value);
    if (!sample || !std::isfinite(sample->heading)) return nullptr;
    auto seen = mrpt::obs::CObservationIMU::Create();
    seen->timestamp = mrpt::Clock::fromDouble(t);
    seen->set(mrpt::obs::IMU_YAW, sample->heading);
    return seen;
  }

  [[nodiscard]] std::optional<SourceErrors> Errors() const override {
    return SourceErrors{
        .names = {"compass_offset_rad", "compass_deviation_sin_rad", "compass_deviation_cos_rad"},
        .sigma = Eigen::Vector3d::Constant(params_.deviation.value())};
  }

  [[nodiscard]] std::optional<Term> Measure(const mrpt::obs::CObservation& seen,
                                            int errors) override {
    const double t = mrpt::Clock::toDouble(seen.timestamp);
    if (t - used_t_ < params_.period.value()) return std::nullopt;
    used_t_ = t;
    const auto& imu = dynamic_cast<const mrpt::obs::CObservationIMU&>(seen);
    return Term::OnObservation(CompassFactor(Radians(imu.get(mrpt::obs::IMU_YAW)), params_.sigma),
                               errors);
  }

 private:
  Params params_;
  double used_t_ = kLongAgo;
};

LIMPET_REGISTER_SOURCE(MagneticHeading, "magnetic_heading");

}  // namespace
}  // namespace limpet
