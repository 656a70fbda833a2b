// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"

namespace limpet {

/// Vetoes options that leave the operating region or enter a keep-out zone, and steers back inside
/// should the vehicle have left it. For a vehicle that is outside, e.g. at its start, it asks for a
/// way in. The region is in force once it has been entered, and no more on the way home, which may
/// end anywhere, but leads through no zone either. Where the vehicle does not know its place well
/// enough to be sure that it is inside, it says so.
class BHV_OpRegion final : public Behavior {
 public:
  struct Params {
    Meters tolerance{0.5};
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("tolerance_m", tolerance, "Further outside than this raises the alarm and turns back",
            InRange(Meters(0.0), Meters(20.0)));
    }
  };
  explicit BHV_OpRegion(const Params& params) : params_(params) {}
  void Start(const VehicleState& state) override;
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;
  void Shape(const Situation& now, double weight, SearchGoals& goals) const override;
  [[nodiscard]] std::optional<Bid> Value(const Prospect& prospect,
                                         const Situation& now) const override;

 private:
  /// Whether three sigmas of the vehicle's place reach over a border.
  [[nodiscard]] bool IsInDoubt(const VehicleState& state);

  Params params_;
  std::optional<SurveyArea> area_;
  std::optional<Region> region_;  ///< of that area
  bool has_entered_ = false;      ///< has been inside since it began to run
  bool is_in_doubt_ = false;      ///< of being inside
};

}  // namespace limpet
