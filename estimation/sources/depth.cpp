// SPDX-License-Identifier: MIT
// A pressure sensor.
#include "estimation/navigation/observation_forms.hpp"
#include "estimation/navigation/source_registry.hpp"
#include "limpet/topics/sensors.hpp"

namespace limpet {
namespace {

class DepthSensor final : public MotionSensor {
 public:
  struct Params {
    std::string variable = topics::kDepthSensor.name;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("variable", variable, "Says the depth below the surface, a number [m]");
    }
  };
  explicit DepthSensor(const Params& params) : params_(params) {}

  [[nodiscard]] std::string variable() const override { return params_.variable; }

  [[nodiscard]] ObservationPtr Observe(double t, const Value& value) const override {
    const auto depth = TopicCodec<double>::Decode(value);
    return depth ? ObservationOf(DepthReading{.t = t, .depth = *depth}) : nullptr;
  }

  [[nodiscard]] std::optional<MotionReading> ReadingOf(
      const mrpt::obs::CObservation& seen) const override {
    return DepthOf(seen);
  }

 private:
  Params params_;
};

LIMPET_REGISTER_SOURCE(DepthSensor, "depth");

}  // namespace
}  // namespace limpet
