// SPDX-License-Identifier: MIT
// What a detector finds in the images of a camera.
#include <utility>

#include "estimation/navigation/observation_forms.hpp"
#include "estimation/navigation/source_registry.hpp"
#include "limpet/topics/sensors.hpp"

namespace limpet {
namespace {

class Boxes final : public MotionSensor {
 public:
  struct Params {
    std::string variable = topics::kDetections.name;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("variable", variable, "Says the boxes of a frame, as DETECTIONS does");
    }
  };
  explicit Boxes(const Params& params) : params_(params) {}

  [[nodiscard]] std::string variable() const override { return params_.variable; }

  [[nodiscard]] ObservationPtr Observe(double t, const Value& value) const override {
    const auto frame = TopicCodec<Detections>::Decode(value);
    return frame ? ObservationOf(*frame, t) : nullptr;
  }

  [[nodiscard]] std::optional<MotionReading> ReadingOf(
      const mrpt::obs::CObservation& seen) const override {
    std::optional<SeenFrame> frame = FrameOf(seen);
    if (!frame) return std::nullopt;
    return std::move(frame->frame);
  }

 private:
  Params params_;
};

LIMPET_REGISTER_SOURCE(Boxes, "boxes");

}  // namespace
}  // namespace limpet
