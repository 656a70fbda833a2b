// SPDX-License-Identifier: MIT
// Fixes at the surface.
#include "estimation/navigation/observation_forms.hpp"
#include "estimation/navigation/source_registry.hpp"
#include "limpet/topics/sensors.hpp"

namespace limpet {
namespace {

class Gps final : public MotionSensor {
 public:
  struct Params {
    std::string variable = topics::kGpsData.name;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("variable", variable, "Says a fix and its 1-sigma, as GPS_DATA does");
    }
  };
  explicit Gps(const Params& params) : params_(params) {}

  [[nodiscard]] std::string variable() const override { return params_.variable; }

  [[nodiscard]] ObservationPtr Observe(double t, const Value& value) const override {
    const auto s = TopicCodec<GpsFix>::Decode(value);
    if (!s) return nullptr;
    return ObservationOf(PositionFix{.t = t, .p_W = {s->north, s->east}, .sd = s->sd});
  }

  [[nodiscard]] std::optional<MotionReading> ReadingOf(
      const mrpt::obs::CObservation& seen) const override {
    return FixOf(seen);
  }

 private:
  Params params_;
};

LIMPET_REGISTER_SOURCE(Gps, "gps");

}  // namespace
}  // namespace limpet
