// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/helm/act_list.hpp"
#include "limpet/helm/behavior.hpp"
#include "limpet/shapes/visual_hints.hpp"
#include "limpet/waypoints/convex_polygon.hpp"

namespace limpet {

/// Guards where the vehicle goes: outside the save polygon it steers back, outside the halt
/// polygon, too deep, too low or after too long it stops the vehicle. Parameters, flags, macros and
/// hints are spelled as existing MOOS-IvP missions spell them; docs/everyday.md. The region of a
/// survey is BHV_OpRegion's.
class BHV_OpRegionV24 final : public Behavior {
 public:
  struct Params {
    std::optional<ConvexPolygon> core{}, save{}, halt{};
    std::optional<double> save_distance{}, halt_distance{};  ///< about the core [m]
    std::optional<Meters> deepest{}, least_altitude{};
    std::optional<Seconds> longest{};
    bool waits_for_entry = true;  ///< the halt polygon counts once it has been entered
    Seconds entry_time{1.0}, exit_time{0.5};
    MetersPerSecond recover_speed{0.8};
    bool is_reset = false;
    std::string reset_variable{};
    std::vector<Flag> poly_flags{}, time_flags{}, altitude_flags{}, depth_flags{};
    std::vector<Flag> save_flags{}, savex_flags{};
    bool draws_save = true, draws_halt = true;
    VisualHints hints{};
    std::string halt_key = "halt_poly";  ///< as its block calls the halt polygon
    std::string core_variable{};         ///< whose mail is another core
    /// Of BHV_OpRegion alone: outside the halt polygon it gives the vehicle to the operator, in
    /// place of stopping it; variables for the time left, and for the halt polygon.
    bool is_soft = false;
    std::string time_variable{}, polygon_variable{};
    bool tells_borders = false;  ///< OPREG_* and SECS_IN_POLY, also of BHV_OpRegion alone
    void Describe(ParamCollector& visit);
    /// Keys that BHV_OpRegion has, too: limits, their flags, and a polygon that may not be left.
    void DescribeLimits(ParamCollector& visit, const char* key);
  };
  /// Throws ConfigError for distances about a core that is not given.
  explicit BHV_OpRegionV24(const Params& params);

  [[nodiscard]] std::vector<std::string> Variables() const override;
  [[nodiscard]] std::optional<std::string> Macro(std::string_view name,
                                                 const VehicleState& state) const override;
  [[nodiscard]] bool TakeOver(const Behavior& former,
                              const std::vector<std::string>& keys) override;
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;
  [[nodiscard]] std::vector<BehaviorAct> Idle(const VehicleState& state) override;
  [[nodiscard]] std::vector<BehaviorAct> Stop(const VehicleState& state) override;

 private:
  /// What the behavior has noticed since the helm began, or since it was reset.
  struct Watch {
    std::optional<Seconds> began;
    std::optional<Seconds> entered_halt, left_halt, left_save;
    bool was_in_halt = false;  ///< for long enough to count
    bool was_in_save = false;
    /// The way round on which it turns back, until it heads for the save polygon.
    enum class Turn { kNone, kLeft, kRight } turn = Turn::kNone;
    /// Limits that are breached now: their flags go out as that begins.
    bool breaches_poly = false, breaches_time = false;
    bool breaches_altitude = false, breaches_depth = false;
  };

  void Begin(const VehicleState& state);
  /// Mail with another core moves the polygons about it.
  void HearCore(const VehicleState& state);
  void TellTimeLeft(const VehicleState& state, ActList& acts) const;
  /// The vehicle is the operator's, and the halt polygon counts once it has been entered again.
  void GiveUp(const VehicleState& state, ActList& acts);
  void Guard(bool is_breached, const std::string& reason, const std::vector<Flag>& flags,
             bool& was_breached, const VehicleState& state, ActList& acts);
  void GuardLimits(const VehicleState& state, ActList& acts);
  void GuardHalt(const VehicleState& state, ActList& acts);
  /// True if the vehicle has left the save polygon.
  [[nodiscard]] bool MustReturn(const VehicleState& state, ActList& acts);
  void SteerBack(const VehicleState& state, ActList& acts, MotionBid& bid);
  /// Settles which way round it turns back, while it does not head for the save polygon.
  void CommitTurn(const VehicleState& state, ActList& acts);
  /// How far the border is, and how long it has been inside.
  void TellBorders(const VehicleState& state, ActList& acts) const;
  void Draw(const VehicleState& state, bool is_active, ActList& acts) const;
  void EraseStatus(const VehicleState& state, ActList& acts) const;
  void DrawStatus(const VehicleState& state, const std::string& hint, const char* color,
                  bool is_active, ActList& acts) const;
  /// The polygon that a macro ends with, e.g. SAVE; null if there is none.
  [[nodiscard]] const ConvexPolygon* PolygonOf(std::string_view macro) const;
  [[nodiscard]] std::optional<std::string> DistanceMacro(std::string_view name,
                                                         const VehicleState& state) const;

  Params params_;
  std::optional<ConvexPolygon> save_, halt_;
  Watch watch_;
  std::optional<Seconds> reset_at_;  ///< time of the mail that reset it last
  std::optional<Seconds> core_at_;   ///< of the last that moved its core
  bool is_core_refused_ = false;     ///< the last mail of it was no polygon
  bool is_polygon_told_ = false;     ///< in `polygon_variable`
};

}  // namespace limpet
