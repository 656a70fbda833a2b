// SPDX-License-Identifier: MIT
// How far the seabed is along the four beams of a DVL: what the map is made of.
#include "estimation/navigation/observation_forms.hpp"
#include "estimation/navigation/source_registry.hpp"
#include "limpet/topics/sensors.hpp"

namespace limpet {
namespace {

class DvlBeams final : public MotionSensor {
 public:
  struct Params {
    std::string variable = topics::kDvlData.name;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("variable", variable, "Says four slant ranges, as DVL_DATA does");
    }
  };
  explicit DvlBeams(const Params& params) : params_(params) {}

  [[nodiscard]] std::string variable() const override { return params_.variable; }

  [[nodiscard]] ObservationPtr Observe(double t, const Value& value) const override {
    const auto s = TopicCodec<DvlSample>::Decode(value);
    return s ? ObservationOf(SlantRanges{.t = t, .beams = s->beams()}) : nullptr;
  }

  [[nodiscard]] std::optional<MotionReading> ReadingOf(
      const mrpt::obs::CObservation& seen) const override {
    return SlantRangesOf(seen);
  }

 private:
  Params params_;
};

LIMPET_REGISTER_SOURCE(DvlBeams, "dvl_beams");

}  // namespace
}  // namespace limpet
