// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"

namespace limpet {

/// Bids on nothing: lives for its `duration` and posts how long it has run and been idle.
/// Parameters are spelled as existing MOOS-IvP missions spell them.
class BHV_Timer final : public Behavior {
 public:
  struct Params {
    std::string idle_variable = "TIMER_IDLE", running_variable = "TIMER_RUNNING";
    std::string suffix{};
    void Describe(ParamCollector& visit);
  };
  explicit BHV_Timer(const Params& params) : params_(params) {}
  [[nodiscard]] bool TakeOver(const Behavior& former,
                              const std::vector<std::string>& keys) override;
  void Restart() override { times_ = {}; }
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;
  [[nodiscard]] std::vector<BehaviorAct> Idle(const VehicleState& state) override;

 private:
  struct Times {
    Seconds running{0.0}, idle{0.0};
    std::optional<Seconds> last;
  };
  [[nodiscard]] std::vector<BehaviorAct> Spend(const VehicleState& state, bool is_running);

  Params params_;
  Times times_;
};

}  // namespace limpet
