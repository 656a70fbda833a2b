// SPDX-License-Identifier: MIT
// Lesson 3: a behavior says what it would like; the helm adds all wishes and takes the best.
#include <vector>

#include <fmt/format.h>

#include "limpet/helm/motion_decision.hpp"
#include "limpet/helm/registry.hpp"

namespace limpet {
namespace {

/// Keeps the vehicle below the keels of what sails above it: no opinion about course and speed,
/// and the deeper the better down to `draught_m`.
class BHV_StayBelowKeels final : public Behavior {
 public:
  struct Params {
    Meters draught{3.0};
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("draught_m", draught, "No keel is deeper", InRange(Meters(0.5), Meters(30.0)));
    }
  };
  explicit BHV_StayBelowKeels(const Params& params) : params_(params) {}

  [[nodiscard]] MotionBid Move(const VehicleState& state) override {
    MotionBid bid;
    if (state.nav.down < params_.draught.value()) {
      bid.depth = Peak{.summit = params_.draught.value(),
                       .flat_half_width = 0.0,
                       .base_half_width = params_.draught.value()};
    }
    return bid;
  }

 private:
  Params params_;
};

LIMPET_REGISTER_BEHAVIOR(BHV_StayBelowKeels);

double DepthChosenAt(double depth) {
  ConfigBlock block;  // what a .bhv file says of the behavior; here nothing, so defaults
  const auto behavior = BehaviorRegistry().at("BHV_StayBelowKeels").create(block);
  VehicleState state;
  state.nav.down = depth;
  const std::vector<WeightedBehavior> running{
      {.name = "keels", .weight = 100.0, .behavior = behavior.get()}};
  return DecideMotion(running, state, MotionDomain{}).depth.value_or(depth);
}

int Run() {
  fmt::print("at 1 m: go to {} m, at 5 m: stay at {} m\n", DepthChosenAt(1.0), DepthChosenAt(5.0));
  return 0;
}

}  // namespace
}  // namespace limpet

int main() { return limpet::Run(); }
