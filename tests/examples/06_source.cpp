// SPDX-License-Identifier: MIT
// Lesson 6: a sensor that pNav has never heard of aids its estimate; pNav hears whichever its
// `sources` name.
#include <memory>

#include <fmt/format.h>
#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationRange.h>

#include "estimation/navigation/navigator.hpp"
#include "estimation/navigation/source_registry.hpp"
#include "estimation/smoothing/factors/beacon_factor.hpp"

namespace limpet {
namespace {

/// A line from the vehicle to its boat that says how much of it is paid out.
class TetherSource final : public MeasurementSource {
 public:
  struct Params {
    Eigen::Vector3d winch = Eigen::Vector3d::Zero();
    Meters sigma{0.5};
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("winch_m", winch, "m", "Where the line begins: north, east, down");
      visit("sigma_m", sigma, "1-sigma of its length, slack included", AtLeast(Meters(0.01)));
    }
  };
  explicit TetherSource(const Params& params) : params_(params) {}

  [[nodiscard]] std::string variable() const override { return "TETHER_LENGTH"; }

  [[nodiscard]] mrpt::obs::CObservation::Ptr Observe(double t, const Value& value) const override {
    const auto* length = std::get_if<double>(&value);
    if (length == nullptr || !(*length > 0.0)) return nullptr;
    auto seen = mrpt::obs::CObservationRange::Create();
    seen->timestamp = mrpt::Clock::fromDouble(t);
    seen->sensedData.emplace_back().sensedDistance = static_cast<float>(*length);
    return seen;
  }

  [[nodiscard]] std::optional<Term> Measure(const mrpt::obs::CObservation& seen,
                                            int /*errors*/) override {
    const auto& range = dynamic_cast<const mrpt::obs::CObservationRange&>(seen);
    const Meters length(range.sensedData.front().sensedDistance);
    return Term::OnPose(
        BeaconFactor(params_.winch, Eigen::Vector3d::Zero(), length, params_.sigma));
  }

 private:
  Params params_;
};

LIMPET_REGISTER_SOURCE(TetherSource, "tether");

int Run() {
  const std::unique_ptr<MeasurementSource> winch = (*FindSource("tether"))->Make();
  Navigator navigator{NavigatorParams{}};
  const int tether = navigator.AddSource((*FindSource("tether"))->Make());
  for (int i = 0; i < 6000; ++i) {  // five minutes north, of which the DVL makes 2 per cent more
    const double t = 0.05 * i, north = 0.5 * t;
    navigator.AddAttitude({.t = t});
    if (i == 0) navigator.AddGps(t, {0.0, 0.0}, 0.5);
    if (i % 4 == 0) navigator.AddVelocity(t, Eigen::Vector3d(0.51, 0.0, 0.0));
    if (i % 20 == 19) navigator.AddObservation(tether, winch->Observe(t, Value(north)));
    navigator.Advance(t);
  }
  fmt::print("{:.0f} m north\n", navigator.Estimate(300.0).X_WB.p_WB.x());  // 153 without
  return 0;
}

}  // namespace
}  // namespace limpet

int main() { return limpet::Run(); }
