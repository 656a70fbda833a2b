// SPDX-License-Identifier: MIT
// A fibre-optic gyro about the body z axis, which yaw is integrated from.
#include "estimation/navigation/observation_forms.hpp"
#include "estimation/navigation/source_registry.hpp"
#include "limpet/topics/sensors.hpp"

namespace limpet {
namespace {

class Fog final : public MotionSensor {
 public:
  struct Params {
    std::string variable = topics::kFogYawRate.name;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("variable", variable, "Says the rate about the body z axis, a number [rad/s]");
    }
  };
  explicit Fog(const Params& params) : params_(params) {}

  [[nodiscard]] std::string variable() const override { return params_.variable; }

  [[nodiscard]] ObservationPtr Observe(double t, const Value& value) const override {
    const auto rate = TopicCodec<double>::Decode(value);
    return rate ? ObservationOf(YawRate{.t = t, .rate = *rate}) : nullptr;
  }

  [[nodiscard]] std::optional<MotionReading> ReadingOf(
      const mrpt::obs::CObservation& seen) const override {
    return YawRateOf(seen);
  }

 private:
  Params params_;
};

LIMPET_REGISTER_SOURCE(Fog, "fog");

}  // namespace
}  // namespace limpet
