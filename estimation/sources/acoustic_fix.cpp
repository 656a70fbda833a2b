// SPDX-License-Identifier: MIT
// Where an acoustic positioning system (USBL, or LBL that solves for itself) has the vehicle.
#include <cmath>

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include "estimation/navigation/source_registry.hpp"
#include "estimation/smoothing/factors/position_factor.hpp"
#include "limpet/core/long_ago.hpp"
#include "limpet/topics/sensors.hpp"

namespace limpet {
namespace {

class AcousticFix final : public MeasurementSource {
 public:
  struct Params {
    Meters sigma{1.0}, constant_sigma{1.0};
    Seconds correlation{10.0};
    template <class Visitor>
    void Describe(Visitor& visit) {
      using namespace literals;
      visit("sigma_m", sigma, "1-sigma of each axis of a fix, at least", InRange(0.01_m, 1000.0_m));
      visit(
          "constant_sigma_m", constant_sigma,
          "1-sigma of each axis of what all fixes are off by alike, e.g. for a transceiver that is "
          "not where it is said to be: estimated with the track",
          InRange(0.01_m, 1000.0_m));
      visit("correlation_s", correlation, "Fixes closer together err alike and count as one",
            InRange(0.0_s, 600.0_s));
    }
  };
  explicit AcousticFix(const Params& params) : params_(params) {}

  [[nodiscard]] std::string variable() const override { return topics::kUsblFix.name; }

  [[nodiscard]] mrpt::obs::CObservation::Ptr Observe(double t, const Value& value) const override {
    const auto fix = TopicCodec<UsblFix>::Decode(value);
    if (!fix || !std::isfinite(fix->north + fix->east + fix->down)) return nullptr;
    auto seen = mrpt::obs::CObservationRobotPose::Create();
    seen->timestamp = mrpt::Clock::fromDouble(t);
    seen->pose.mean = mrpt::poses::CPose3D(fix->north, fix->east, fix->down, 0.0, 0.0, 0.0);
    const double sd = std::max(params_.sigma.value(), std::isfinite(fix->sd) ? fix->sd : 0.0);
    seen->pose.cov.setZero();
    for (int axis = 0; axis < 3; ++axis)
      seen->pose.cov(axis, axis) = sd * sd;
    return seen;
  }

  [[nodiscard]] std::optional<SourceErrors> Errors() const override {
    return SourceErrors{
        .names = {"acoustic_off_north_m", "acoustic_off_east_m", "acoustic_off_down_m"},
        .sigma = Eigen::Vector3d::Constant(params_.constant_sigma.value())};
  }

  [[nodiscard]] std::optional<Term> Measure(const mrpt::obs::CObservation& seen,
                                            int errors) override {
    const double t = mrpt::Clock::toDouble(seen.timestamp);
    const double since = t - used_t_;
    used_t_ = t;
    const auto& pose = dynamic_cast<const mrpt::obs::CObservationRobotPose&>(seen).pose;
    const double worth = std::max(params_.correlation.value() / std::max(since, 1e-3), 1.0);
    Eigen::Vector3d sigma;
    for (int axis = 0; axis < 3; ++axis)
      sigma(axis) = std::sqrt(worth * pose.cov(axis, axis));
    return Term::OnObservation(PositionFactor({pose.mean.x(), pose.mean.y(), pose.mean.z()}, sigma),
                               errors);
  }

  [[nodiscard]] bool is_fix() const override { return true; }

 private:
  Params params_;
  double used_t_ = kLongAgo;
};

LIMPET_REGISTER_SOURCE(AcousticFix, "acoustic_fix");

}  // namespace
}  // namespace limpet
