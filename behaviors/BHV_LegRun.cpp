// SPDX-License-Identifier: MIT
#include "behaviors/BHV_LegRun.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "limpet/core/decimal_text.hpp"
#include "limpet/helm/flag_macros.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/helm/updated_keys.hpp"
#include "limpet/waypoints/way_drawing.hpp"

namespace limpet {
namespace {

using LegStep = WaypointProgress::Step;

void ApplyEdits(std::vector<BHV_LegRun::Edit> edits, LegPlan& plan) {
  std::stable_partition(edits.begin(), edits.end(),
                        [](const BHV_LegRun::Edit& edit) { return edit.is_place; });
  for (const BHV_LegRun::Edit& edit : edits) {
    edit.apply(plan);
  }
}

/// What an update that gives `keys` changes: of lines with one meaning the last is the update's.
std::vector<BHV_LegRun::Edit> EditsOf(const std::vector<BHV_LegRun::Edit>& all,
                                      const std::vector<std::string>& keys) {
  std::vector<BHV_LegRun::Edit> edits;
  for (const BHV_LegRun::Edit& edit : all) {
    const bool is_meant = std::ranges::any_of(
        edit.keys, [&keys](const std::string& key) { return HasKey(keys, {key}); });
    if (!is_meant) continue;
    std::erase_if(edits,
                  [&edit](const BHV_LegRun::Edit& before) { return before.keys == edit.keys; });
    edits.push_back(edit);
  }
  return edits;
}

double LengthOf(const std::vector<MapPoint>& way) {
  double length = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    length += DistanceBetween(way[i - 1], way[i]);
  }
  return length;
}

}  // namespace

BHV_LegRun::BHV_LegRun(Params params) : params_(std::move(params)) {
  ApplyEdits(params_.edits, plan_);
}

bool BHV_LegRun::TakeOver(const Behavior& former, const std::vector<std::string>& keys) {
  const auto& old = dynamic_cast<const BHV_LegRun&>(former);
  plan_ = old.plan_;
  run_ = old.run_;
  crossings_ = old.crossings_;
  run_.legs.SetRepeats(params_.repeats);
  const std::vector<Edit> edits = EditsOf(params_.edits, keys);
  ApplyEdits(edits, plan_);
  if (!edits.empty()) run_.is_begun = false;
  if (HasKey(keys, {"leg_spds"})) run_.next_speed = 0;
  return true;
}

void BHV_LegRun::Start(const VehicleState&) {
  run_.legs.ForgetApproach();
  run_.is_turning = false;  // what was left of a turn is not made up for: on to the next leg
  run_.last.reset();
}

void BHV_LegRun::Begin(const MapPoint& at) {
  const auto toward = [&](std::size_t end) { return DistanceBetween(at, plan_.end(end)); };
  const bool second_is_nearer = toward(1) < toward(0);
  const bool is_second = (params_.first_leg == "close_turn" && second_is_nearer) ||
                         (params_.first_leg == "far_turn" && !second_is_nearer);
  const Run former = std::exchange(run_, Run());
  run_.is_begun = true;
  run_.next_speed = former.next_speed;
  run_.told_mode = former.told_mode;
  run_.legs.SetPoints({plan_.end(0), plan_.end(1)});
  run_.legs.SetRepeats(params_.repeats);
  if (is_second) run_.legs.SetIndex(1);
}

/// The speed of the leg that begins: the next of the list, as far as that goes.
void BHV_LegRun::TakeSpeed() {
  run_.speed.reset();
  const std::vector<double>& speeds = params_.leg_speeds;
  if (run_.next_speed >= speeds.size() && params_.repeats_speeds) run_.next_speed = 0;
  if (run_.next_speed < speeds.size()) run_.speed = speeds[run_.next_speed++];
}

void BHV_LegRun::AdvanceLeg(const VehicleState& state, ActList& acts) {
  const std::size_t reached = run_.legs.index();
  const LegStep step = run_.legs.Advance(state.place(), params_.capture);
  if (step == LegStep::kUnderway) {
    if (run_.legs_done > 0 && !run_.is_mid_told && Share(state.place()) > params_.mid_leg) {
      run_.is_mid_told = true;
      acts.RaiseAgain(params_.mid_leg_flags, *this, state);
    }
    return;
  }
  acts.RaiseAgain(params_.leg_flags, *this, state);
  acts.RaiseAgain(reached == 0 ? params_.leg1_flags : params_.leg2_flags, *this, state);
  if (step != LegStep::kAdvanced) acts.RaiseAgain(params_.cycle_flags, *this, state);
  if (step == LegStep::kCompleted) {
    acts.Complete();
    run_.legs.Restart();
  }
  ++run_.legs_done;
  run_.is_turning = true;
  run_.is_mid_told = false;
  run_.turn_end = reached;
  run_.turn = {};
  run_.turn.SetPoints(plan_.TurnPoints(reached));
  if (!params_.keeps_speed_in_turns) run_.speed.reset();
}

void BHV_LegRun::AdvanceTurn(const VehicleState& state, ActList& acts) {
  if (run_.turn.Advance(state.place(), params_.capture) != LegStep::kCompleted) {
    if (!run_.is_mid_told && Share(state.place()) > params_.mid_turn) {
      run_.is_mid_told = true;
      acts.RaiseAgain(params_.mid_turn_flags, *this, state);
    }
    return;
  }
  acts.RaiseAgain(params_.turn_flags, *this, state);
  acts.RaiseAgain(run_.turn_end == 0 ? params_.turn1_flags : params_.turn2_flags, *this, state);
  run_.is_turning = false;
  run_.is_mid_told = false;
  run_.leg_odo = 0.0;
  crossings_.Reset();
  run_.legs.ForgetApproach();
  TakeSpeed();
}

void BHV_LegRun::Advance(const VehicleState& state, ActList& acts) {
  const MapPoint at = state.place();
  crossings_.Move(at);
  if (run_.last && !run_.is_turning) run_.leg_odo += DistanceBetween(*run_.last, at);
  run_.last = at;
  run_.is_turning ? AdvanceTurn(state, acts) : AdvanceLeg(state, acts);
}

MapPoint BHV_LegRun::SteeringPoint(const MapPoint& at) const {
  const MapPoint& next = way().next();
  if (params_.lead.lead <= 0.0) return next;
  if (run_.is_turning) {
    const std::size_t index = run_.turn.index();
    return index == 0 ? next : LeadPoint({run_.turn.points()[index - 1], next}, at, params_.lead);
  }
  return LeadPoint({plan_.end(1 - end()), next}, at, params_.lead);
}

MotionBid BHV_LegRun::Move(const VehicleState& state) {
  MotionBid bid;
  ActList acts;
  if (!plan_.is_set()) {
    acts.Post("BHV_WARNING", name() + ": its leg is not set; `p1` and `p2`, or `leg`, say it");
    bid.acts = acts.Take();
    return bid;
  }
  if (!run_.is_begun) Begin(state.place());
  Advance(state, acts);
  TellMode(state, acts);
  Draw(state, true, acts);
  const double speed = run_.speed.value_or(params_.speed.value());
  acts.Post("LR_NOW_SPD", speed);
  const double course_share = params_.patience / 100.0;
  bid.course = Peak{.summit = BearingTo(state.place(), SteeringPoint(state.place())),
                    .flat_half_width = 0.0,
                    .base_half_width = std::numbers::pi,
                    .share = course_share};
  bid.table = uneven_speed_.Around({.speed = speed, .share = 1.0 - course_share}, state.domain);
  bid.acts = acts.Take();
  return bid;
}

std::vector<BehaviorAct> BHV_LegRun::Stop(const VehicleState& state) {
  ActList acts;
  if (run_.is_begun) Draw(state, false, acts);
  return acts.Take();
}

std::vector<BehaviorAct> BHV_LegRun::Idle(const VehicleState& state) {
  crossings_.Move(state.place());
  return {};
}

std::string BHV_LegRun::ModeText() const {
  if (!run_.is_begun) return "init";
  return fmt::format("{}{}", run_.is_turning ? "turn" : "leg", end() + 1);
}

void BHV_LegRun::TellMode(const VehicleState& state, ActList& acts) {
  const std::string mode = ModeText();
  if (std::exchange(run_.told_mode, mode) == mode) return;
  acts.Post("LR_MODE", mode);
  acts.Post("LR_MODE_REPORT",
            fmt::format("vname={},mode={},utc={:.2f}", state.ownship, mode, state.now.value()));
}

double BHV_LegRun::Share(const MapPoint& at) const {
  const double whole = run_.is_turning ? LengthOf(run_.turn.points()) : plan_.length();
  const double left =
      run_.is_turning ? run_.turn.ToEndOfCycle(at) : DistanceBetween(at, run_.legs.next());
  return 100.0 * std::clamp(1.0 - left / std::max(whole, 1e-9), 0.0, 1.0);
}

void BHV_LegRun::Draw(const VehicleState& state, bool is_active, ActList& acts) const {
  const std::string vehicle(state.ownship);
  const WayDrawing drawing{.vehicle = vehicle, .behavior = name(), .hints = params_.hints};
  const MapPoint next = way().next();
  acts.Draw(is_active ? drawing.Draw(way().points(), next, SteeringPoint(state.place()))
                      : drawing.Erase(way().points(), next));
  const VisualHints& hints = params_.hints;
  std::vector<DrawnText> drawn;
  for (std::size_t i = 0; i < 2; ++i) {
    drawn.push_back(
        DrawnTextOf({.label = fmt::format("{}_p{}", vehicle, i + 1),
                     .form = PointShape{plan_.end(i)},
                     .style = {.label_color = hints.Text("legpt_label_color", "off"),
                               .vertex_color = hints.Text("legpt_vertex_color", "orange"),
                               .vertex_size = hints.Number("legpt_vertex_size", 7.0)},
                     .is_active = is_active},
                    fmt::format("p{}", i + 1)));
    drawn.push_back(
        DrawnTextOf({.label = fmt::format("{}_pview{}", vehicle, i + 1),
                     .form = SeglistShape{plan_.TurnPoints(i)},
                     .style = {.label_color = hints.Text("turn_label_color", "off"),
                               .edge_color = hints.Text("turn_edge_color", "gray30"),
                               .vertex_color = hints.Text("turn_vertex_color", "gray70"),
                               .vertex_size = hints.Number("turn_vertex_size", 2.0),
                               .edge_size = hints.Number("turn_edge_size", 1.0)},
                     .is_active = is_active},
                    fmt::format("pview{}", i + 1)));
  }
  acts.Draw(drawn);
}

std::optional<std::string> BHV_LegRun::Macro(std::string_view name,
                                             const VehicleState& state) const {
  const auto count = [](auto number) { return fmt::format("{}", number); };
  if (name == "SPEED") return MacroNumber(params_.speed.value());
  if (name == "MODE") return ModeText();
  if (name == "CYCLES") return count(run_.legs.cycles());
  if (name == "CYCREM") return count(run_.legs.repeats_left().value_or(0));
  if (name == "WPTS_HIT") return count(run_.legs.hits());
  if (name == "LEG_ID") return count(run_.legs_done);
  if (name == "WRAPS") return count(crossings_.count());
  if (name == "LEG_ODO") return MacroNumber(run_.leg_odo);
  if (!run_.is_begun) return std::nullopt;
  const MapPoint at = state.place(), next = run_.legs.next();
  if (name == "NI") return count(run_.legs.index());
  if (name == "NX") return MacroNumber(next.x);
  if (name == "NY") return MacroNumber(next.y);
  if (name == "DIST_NP") return MacroNumber(DistanceBetween(at, next));
  if (name == "DIST_PP") return MacroNumber(DistanceBetween(at, run_.legs.previous().value_or(at)));
  constexpr double kHundred = 100.0;
  if (name == "PCT_NP") return MacroNumber(Share(at) / kHundred);
  return std::nullopt;
}

LIMPET_REGISTER_BEHAVIOR(BHV_LegRun);

}  // namespace limpet
