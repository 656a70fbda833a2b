// SPDX-License-Identifier: MIT
// What the thrusters are told, from which the speed through the water follows.
#include "estimation/navigation/observation_forms.hpp"
#include "estimation/navigation/source_registry.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {
namespace {

static_assert(ThrusterShares::kMost == ThrusterCommand::kMost);

class Thrusters final : public MotionSensor {
 public:
  struct Params {
    std::string variable = topics::kThrusterCommand.name;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("variable", variable, "Says what the thrusters are told, as THRUSTER_COMMAND does");
    }
  };
  explicit Thrusters(const Params& params) : params_(params) {}

  [[nodiscard]] std::string variable() const override { return params_.variable; }
  /// A vehicle that another pilot steers is known without.
  [[nodiscard]] bool is_dispensable() const override { return true; }

  [[nodiscard]] ObservationPtr Observe(double t, const Value& value) const override {
    const auto command = TopicCodec<ThrusterCommand>::Decode(value);
    return command ? ObservationOf(ThrusterShares{.t = t, .shares = command->Shares()}) : nullptr;
  }

  [[nodiscard]] std::optional<MotionReading> ReadingOf(
      const mrpt::obs::CObservation& seen) const override {
    return ThrusterSharesOf(seen);
  }

 private:
  Params params_;
};

LIMPET_REGISTER_SOURCE(Thrusters, "thrusters");

}  // namespace
}  // namespace limpet
