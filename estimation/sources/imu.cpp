// SPDX-License-Identifier: MIT
// Accelerometer, gyro and magnetic heading in one: what the attitude is filtered from.
#include "estimation/navigation/observation_forms.hpp"
#include "estimation/navigation/source_registry.hpp"
#include "limpet/topics/sensors.hpp"

namespace limpet {
namespace {

class Imu final : public MotionSensor {
 public:
  struct Params {
    std::string variable = topics::kImuData.name;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("variable", variable, "Says force, rates and heading, as IMU_DATA does");
    }
  };
  explicit Imu(const Params& params) : params_(params) {}

  [[nodiscard]] std::string variable() const override { return params_.variable; }

  [[nodiscard]] ObservationPtr Observe(double t, const Value& value) const override {
    const auto s = TopicCodec<ImuSample>::Decode(value);
    if (!s) return nullptr;
    return ObservationOf(InertialInput{.t = t,
                                       .force_B = {s->fx, s->fy, s->fz},
                                       .rate_B = {s->p, s->q, s->r},
                                       .heading = s->heading});
  }

  [[nodiscard]] std::optional<MotionReading> ReadingOf(
      const mrpt::obs::CObservation& seen) const override {
    return InertialOf(seen);
  }

 private:
  Params params_;
};

LIMPET_REGISTER_SOURCE(Imu, "imu");

}  // namespace
}  // namespace limpet
