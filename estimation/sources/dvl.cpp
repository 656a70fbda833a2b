// SPDX-License-Identifier: MIT
// Velocity over ground and altitude of a DVL.
#include "estimation/navigation/observation_forms.hpp"
#include "estimation/navigation/source_registry.hpp"
#include "limpet/topics/sensors.hpp"

namespace limpet {
namespace {

class Dvl final : public MotionSensor {
 public:
  struct Params {
    std::string variable = topics::kDvlData.name;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("variable", variable, "Says velocity and altitude, as DVL_DATA does");
    }
  };
  explicit Dvl(const Params& params) : params_(params) {}

  [[nodiscard]] std::string variable() const override { return params_.variable; }

  [[nodiscard]] ObservationPtr Observe(double t, const Value& value) const override {
    const auto s = TopicCodec<DvlSample>::Decode(value);
    if (!s) return nullptr;
    BottomTrack ping{.t = t, .v_WD_D = {}, .altitude = s->altitude};
    if (s->has_lock && s->u && s->v && s->w) ping.v_WD_D = {*s->u, *s->v, *s->w};
    return ObservationOf(ping);
  }

  [[nodiscard]] std::optional<MotionReading> ReadingOf(
      const mrpt::obs::CObservation& seen) const override {
    return BottomTrackOf(seen);
  }

 private:
  Params params_;
};

LIMPET_REGISTER_SOURCE(Dvl, "dvl");

}  // namespace
}  // namespace limpet
