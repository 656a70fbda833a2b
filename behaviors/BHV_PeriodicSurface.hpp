// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/helm/act_list.hpp"
#include "limpet/helm/behavior.hpp"

namespace limpet {

/// Brings the vehicle up every so often and keeps it there until a fix, or something else that mail
/// tells of, has come. Parameters are spelled as existing MOOS-IvP missions spell them.
class BHV_PeriodicSurface final : public Behavior {
 public:
  /// Each new text of the variable, as a modem's, puts the ascent off.
  struct PutOff {
    std::string variable;
    Seconds each{0.0}, most{0.0};  ///< by one text, and by all of a period
  };
  struct Params {
    Seconds period{300.0};
    std::string mark_variable = "GPS_UPDATE_RECEIVED";
    std::string pending_variable = "PENDING_SURFACE", surface_variable = "TIME_AT_SURFACE";
    std::optional<MetersPerSecond> ascent_speed{};  ///< absent: the speed as the ascent begins
    std::string ascent_grade = "linear";
    Meters zero_speed_depth{0.0};
    Seconds longest_stay{300.0};
    std::optional<PutOff> put_off{};
    void Describe(ParamCollector& visit);
  };
  explicit BHV_PeriodicSurface(const Params& params) : params_(params) {}
  [[nodiscard]] std::vector<std::string> Variables() const override;
  [[nodiscard]] bool TakeOver(const Behavior& former,
                              const std::vector<std::string>& keys) override;
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;
  [[nodiscard]] std::vector<BehaviorAct> Idle(const VehicleState& state) override;

 private:
  enum class Phase { kWaiting, kAscending, kAtSurface };
  struct Dive {
    Phase phase = Phase::kWaiting;
    std::optional<Seconds> marked;      ///< when the period began
    std::optional<limpet::Value> mark;  ///< value of the mark variable, as last seen
    double begin_depth = 0.0;           ///< of the ascent [m]
    double begin_speed = 0.0;           ///< [m/s]
    Seconds surfaced{0.0};
    Seconds put_off{0.0};        ///< by how much, in this period
    std::string put_off_text{};  ///< that it was put off by last
  };

  /// True if mail tells of what it waits for.
  [[nodiscard]] bool IsMarked(const VehicleState& state);
  /// Mail that puts the ascent off is heeded.
  void HearPutOff(const VehicleState& state);
  [[nodiscard]] Seconds Pending(Seconds now) const;
  void Ascend(const VehicleState& state, ActList& acts);
  [[nodiscard]] double AscentSpeed(double depth) const;

  Params params_;
  Dive dive_;
};

}  // namespace limpet
