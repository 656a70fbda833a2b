// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"

namespace limpet {

/// Goes to one depth after another, stays at each for its time, and completes. Parameters are
/// spelled as existing MOOS-IvP missions spell them.
class BHV_GoToDepth final : public Behavior {
 public:
  struct Level {
    double depth = 0.0;  ///< [m]
    Seconds stay{0.0};
  };
  struct Params {
    std::vector<Level> levels{};
    Meters capture_delta{1.0};
    int repeats = 0;
    std::string arrival_flag{};
    void Describe(ParamCollector& visit);
  };
  explicit BHV_GoToDepth(const Params& params) : params_(params), repeats_left_(params.repeats) {}
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;

 private:
  [[nodiscard]] bool HasArrived(double depth);
  /// False after the last one.
  [[nodiscard]] bool GoOn();

  Params params_;
  std::size_t index_ = 0;
  int repeats_left_ = 0;
  int arrivals_ = 0;
  std::optional<Seconds> arrived_;
  std::optional<double> last_depth_;  ///< [m]
};

}  // namespace limpet
