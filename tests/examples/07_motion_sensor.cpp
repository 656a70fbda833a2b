// SPDX-License-Identifier: MIT
// Lesson 7: dead reckoning stands on a DVL that says its velocity in words of its own; pNav hears
// it where its `sensors` name it in the place of `dvl`.
#include <memory>

#include <fmt/format.h>
#include <mrpt/obs/CObservation.h>

#include "estimation/navigation/navigator.hpp"
#include "estimation/navigation/observation_forms.hpp"
#include "estimation/navigation/source_block.hpp"
#include "estimation/navigation/source_registry.hpp"

namespace limpet {
namespace {

/// A DVL of which only the speed ahead comes, e.g. `512` [mm/s].
class SpeedLog final : public MotionSensor {
 public:
  struct Params {
    std::string variable = "SPEED_LOG";
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("variable", variable, "Says the speed ahead over ground, a number [mm/s]");
    }
  };
  explicit SpeedLog(const Params& params) : params_(params) {}

  [[nodiscard]] std::string variable() const override { return params_.variable; }

  [[nodiscard]] ObservationPtr Observe(double t, const Value& value) const override {
    const auto* speed = std::get_if<double>(&value);
    if (speed == nullptr) return nullptr;
    return ObservationOf(
        BottomTrack{.t = t, .v_WD_D = Eigen::Vector3d(1e-3 * *speed, 0.0, 0.0), .altitude = {}});
  }

  [[nodiscard]] std::optional<MotionReading> ReadingOf(
      const mrpt::obs::CObservation& seen) const override {
    return BottomTrackOf(seen);
  }

 private:
  Params params_;
};

LIMPET_REGISTER_SOURCE(SpeedLog, "speed_log");

int Run() {
  std::unique_ptr<MeasurementSource> made = (*FindSource("speed_log"))->Make();
  const std::unique_ptr<MotionSensor> log = TakeMotionSensor(made);
  Navigator navigator{NavigatorParams{}};
  for (int i = 0; i < 2000; ++i) {
    const double t = 0.05 * i;
    navigator.AddAttitude({.t = t});
    if (i == 0) navigator.AddGps(t, {0.0, 0.0}, 0.5);
    if (const auto seen = log->Observe(t, Value(500.0))) {
      const auto ping = std::get<BottomTrack>(*log->ReadingOf(*seen));
      navigator.AddVelocity(ping.t, ping.v_WD_D);
    }
    navigator.Advance(t);
  }
  fmt::print("{:.0f} m north\n", navigator.Estimate(100.0).X_WB.p_WB.x());
  return 0;
}

}  // namespace
}  // namespace limpet

int main() { return limpet::Run(); }
