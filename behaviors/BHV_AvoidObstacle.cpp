// SPDX-License-Identifier: MIT
#include "behaviors/BHV_AvoidObstacle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "limpet/core/frames.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/helm/flag_macros.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/helm/updated_keys.hpp"
#include "limpet/topics/warning.hpp"
#include "limpet/waypoints/map_geometry.hpp"
#include "limpet/waypoints/ray_approach.hpp"
#include "limpet/waypoints/way_drawing.hpp"

namespace limpet {
namespace {

const WarningId kNoObstacle =
    DeclareWarning("OBSTACLE_NOT_SET",
                   {.severity = Severity::kWarning,
                    .raised_by = {"BHV_AvoidObstacle"},
                    .meaning = "The behavior runs and has no obstacle to keep clear of: no say.",
                    .action = "Give its block a poly, or send one by its updates.",
                    .clears = "With the first obstacle, or once the behavior does not run."});

/// Least angle between a heading and what is seen of a polygon from outside it [rad].
double AngleOff(const ConvexPolygon& polygon, const MapPoint& at, double heading) {
  double to_port = std::numbers::pi, to_starboard = std::numbers::pi;
  for (const MapPoint& corner : polygon.corners()) {
    const double off = WrapAngle(BearingTo(at, corner) - heading);
    double& side = off < 0.0 ? to_port : to_starboard;
    side = std::min(side, std::abs(off));
  }
  // Seen on both sides, and from outside under less than half a turn: it lies ahead.
  const bool is_ahead = to_port + to_starboard < std::numbers::pi;
  return is_ahead ? 0.0 : std::min(to_port, to_starboard);
}

/// What a way is worth that comes so near: nothing within `least`, all beyond `free`. Nearer than
/// that already, no way can be better than not to get nearer.
class Worth {
 public:
  Worth(double least, double free, double range)
      : least_(std::min(least, std::max(0.0, range - kStep))), free_(std::min(free, range)) {}
  [[nodiscard]] double Of(double approach) const {
    if (approach >= free_) return 1.0;
    return std::max(0.0, (approach - least_) / (free_ - least_));
  }

 private:
  static constexpr double kStep = 1.0;  // [m]
  double least_, free_;
};

/// Calls `take` with each text of a variable that came since the last iteration, and not before
/// `began`.
template <class Take>
void ForEachText(const VehicleState& state, const char* variable, Seconds began, Take take) {
  for (const Stamped<limpet::Value>& mail : state.Recent(variable)) {
    const auto* text = std::get_if<std::string>(&mail.value);
    if (text != nullptr && mail.time >= began) take(*text);
  }
}

}  // namespace

std::vector<std::string> BHV_AvoidObstacle::Variables() const {
  std::vector<std::string> names{"OBM_RESOLVED"};
  if (params_.can_be_silenced) names.emplace_back("BHV_ABLE_FILTER");
  return names;
}

bool BHV_AvoidObstacle::TakeOver(const Behavior& former, const std::vector<std::string>& keys) {
  const auto& old = dynamic_cast<const BHV_AvoidObstacle&>(former);
  if (!HasKey(keys, {"id"})) passage_ = old.passage_;
  table_ = old.table_;
  return true;
}

void BHV_AvoidObstacle::Start(const VehicleState& state) {
  table_.emplace(state.domain, std::array{MotionVariable::kCourse, MotionVariable::kSpeed});
}

std::optional<BehaviorPost> BHV_AvoidObstacle::Request(const std::string& updates) const {
  return BehaviorPost{.variable = "OBM_ALERT_REQUEST",
                      .value = fmt::format("name={},update_var={},alert_range={:g}", name(),
                                           updates, params_.outer())};
}

double BHV_AvoidObstacle::Range(const VehicleState& state) const {
  return std::max(0.0, params_.polygon->Outside(state.place()));
}

/// It has closed by a metre or more, and now it opens by a metre.
bool BHV_AvoidObstacle::HasPassed(double range) {
  constexpr double kSure = 1.0;  // [m]
  double& extreme = passage_.extreme;
  extreme = passage_.is_closing ? std::min(extreme, range) : std::max(extreme, range);
  const bool turns = std::abs(range - extreme) > kSure;
  if (!turns) return false;
  const bool has_passed = passage_.is_closing;
  if (has_passed) passage_.reported = extreme;
  passage_.is_closing = !passage_.is_closing;
  extreme = range;
  return has_passed;
}

void BHV_AvoidObstacle::HearManager(const VehicleState& state, ActList& acts) {
  const Seconds began = passage_.began.value_or(state.now);
  passage_.began = began;
  ForEachText(state, "OBM_RESOLVED", began, [&](const std::string& id) {
    acts.Post("NOTED_RESOLVED", id);
    if (!params_.id.empty() && id == params_.id) passage_.is_resolved = true;
  });
  if (!params_.can_be_silenced) return;
  ForEachText(state, "BHV_ABLE_FILTER", began,
              [this](const std::string& text) { HearFilter(text); });
}

void BHV_AvoidObstacle::HearFilter(std::string_view text) {
  std::string action, id, source;
  for (const std::string& part : Split(text, ',')) {
    const std::size_t equals = std::min(part.find('='), part.size());
    const std::string_view key = Trim(std::string_view(part).substr(0, equals));
    const std::string_view value =
        equals < part.size() ? Trim(std::string_view(part).substr(equals + 1)) : "";
    if (EqualsIgnoringCase(key, "action")) action = value;
    if (EqualsIgnoringCase(key, "obstacle_id")) id = value;
    if (EqualsIgnoringCase(key, "vsource")) source = value;
  }
  const bool is_meant = id.empty() ? !source.empty() && EqualsIgnoringCase(source, params_.source)
                                   : EqualsIgnoringCase(id, params_.id);
  if (!is_meant) return;
  passage_.is_expunged = passage_.is_expunged || EqualsIgnoringCase(action, "expunge");
  if (EqualsIgnoringCase(action, "disable")) passage_.is_silenced = true;
  if (EqualsIgnoringCase(action, "enable")) passage_.is_silenced = false;
}

bool BHV_AvoidObstacle::Watch(const VehicleState& state, ActList& acts) {
  const double range = Range(state);
  if (!passage_.nearest_ever) passage_.extreme = range;
  passage_.nearest_ever = std::min(passage_.nearest_ever.value_or(range), range);
  const bool has_passed = HasPassed(range);
  if (!has_passed) passage_.reported = *passage_.nearest_ever;
  for (const Flag& flag : params_.range_flags) {
    const auto limit = flag.tag.starts_with('<') ? ParseNumber(flag.tag.substr(1)) : std::nullopt;
    if (!limit || range < *limit) acts.Raise(std::span(&flag, 1), *this, state);
  }
  if (has_passed && range < params_.outer()) acts.Raise(params_.approach_flags, *this, state);
  const bool is_near = range <= params_.end();
  passage_.was_near = passage_.was_near || is_near;
  return passage_.is_resolved || passage_.is_expunged || (passage_.was_near && !is_near);
}

double BHV_AvoidObstacle::Nearness(double range) const {
  const double inner = params_.inner(), outer = params_.outer();
  if (range >= outer) return 0.0;
  return range <= inner ? 1.0 : (outer - range) / (outer - inner);
}

double BHV_AvoidObstacle::Off(const VehicleState& state, double course) const {
  return WrapAngle(BearingTo(state.place(), params_.polygon->Center()) - course);
}

/// Two sides that are worth the same must not take turns: it is settled once the obstacle matters,
/// and open again when it does no more.
void BHV_AvoidObstacle::KeepSide(const VehicleState& state, double relevance) {
  using Side = Passage::Side;
  constexpr double kSettled = 0.6, kOpenBelow = 0.1;  // as MOOS-IvP has it
  if (relevance < kOpenBelow) passage_.side = Side::kOpen;
  if (relevance <= kSettled || passage_.side != Side::kOpen) return;
  passage_.side = Off(state, state.nav.yaw) > 0.0 ? Side::kStarboard : Side::kPort;
}

/// True for a course that has the obstacle on the other side.
bool BHV_AvoidObstacle::ChangesSide(const VehicleState& state, double course) const {
  if (passage_.side == Passage::Side::kOpen) return false;
  return (Off(state, course) > 0.0) != (passage_.side == Passage::Side::kStarboard);
}

double BHV_AvoidObstacle::Relevance(const VehicleState& state) const {
  const double range = Range(state);
  if (range <= 0.0) return 1.0;
  const double nearness = Nearness(range);
  if (nearness <= 0.0) return 0.0;
  constexpr double kAbaft = 110.0 / 180.0 * std::numbers::pi;
  const double off = AngleOff(*params_.polygon, state.place(), state.nav.yaw);
  constexpr double kLeast = 0.01;  // abeam
  return off > kAbaft ? 0.0 : nearness * std::max(kLeast, std::cos(off));
}

void BHV_AvoidObstacle::FillTable(const VehicleState& state, double relevance) {
  const MapPoint at = state.place();
  const ConvexPolygon& polygon = *params_.polygon;
  if (polygon.Contains(at)) {  // out by the shortest way
    const double out = BearingTo(at, polygon.NearestOnBorder(at));
    table_->Fill(
        [&](const MotionPoint& point) { return 0.5 + 0.5 * std::cos(point.course - out); });
    return;
  }
  const Worth worth(params_.least(), params_.free(), Range(state));
  constexpr double kLater = 0.25;  // of the way to 1, if it comes near only after the allowed time
  const bool has_speed = table_->Covers(MotionVariable::kSpeed);
  std::optional<RayApproach> way;
  bool is_other_side = false;
  double course = 0.0, whole = 0.0;
  table_->Fill([&](const MotionPoint& point) {
    if (!way || point.course != course) {  // speeds run faster than courses
      course = point.course;
      way.emplace(polygon, at, course);
      whole = worth.Of(way->distance());
      is_other_side = ChangesSide(state, course);
    }
    if (is_other_side) return 1.0 - relevance;
    const double speed = has_speed ? point.speed : state.speed();
    const double soon = worth.Of(way->Within(speed * params_.allowable_time.value()));
    const double value = whole + (1.0 - whole) * kLater * soon;
    return 1.0 - relevance * (1.0 - value);
  });
}

MotionBid BHV_AvoidObstacle::Move(const VehicleState& state) {
  MotionBid bid;
  ActList acts;
  HearManager(state, acts);
  if (!params_.polygon) {
    bid.warning = BehaviorWarning{kNoObstacle, "it has no poly"};
    bid.acts = acts.Take();
    return bid;
  }
  const double relevance = Relevance(state);
  KeepSide(state, relevance);
  const bool is_inside = params_.polygon->Contains(state.place());
  if (Watch(state, acts)) {
    acts.Complete();
  } else if (passage_.is_silenced) {
    Draw(false, acts);
  } else if (params_.stops_inside && is_inside) {
    acts.Halt("it is inside the obstacle");
  } else if (relevance > 0.0 && table_) {
    if (is_inside) acts.Post("BHV_WARNING", name() + ": it is inside the obstacle");
    FillTable(state, relevance);
    bid.table = &*table_;
    Draw(true, acts);
  }
  bid.acts = acts.Take();
  return bid;
}

std::vector<BehaviorAct> BHV_AvoidObstacle::Idle(const VehicleState& state) {
  ActList acts;
  HearManager(state, acts);
  if (params_.polygon && Watch(state, acts)) acts.Complete();
  return acts.Take();
}

std::vector<BehaviorAct> BHV_AvoidObstacle::Stop(const VehicleState&) {
  ActList acts;
  if (params_.polygon) Draw(false, acts);
  return acts.Take();
}

void BHV_AvoidObstacle::Draw(bool is_active, ActList& acts) const {
  const VisualHints& hints = params_.hints;
  const std::string label = params_.label.empty() ? name() : params_.label;
  const auto draw = [&](const char* key, const std::string& own_label, const std::string& prefix,
                        std::vector<MapPoint> corners, double transparency) {
    acts.Draw(std::vector{DrawnTextOf(
        {.label = own_label,
         .form = PolygonShape{std::move(corners)},
         .style = {.label_color = hints.Text(prefix + "label_color", "off"),
                   .edge_color = hints.Text(prefix + "edge_color", "gray60"),
                   .vertex_color = hints.Text(prefix + "vertex_color", "dodger_blue"),
                   .fill_color = hints.Text(prefix + "fill_color", "gray70"),
                   .vertex_size = hints.Number(prefix + "vertex_size", 1.0),
                   .edge_size = hints.Number(prefix + "edge_size", 1.0),
                   .fill_transparency = hints.Number(prefix + "fill_transparency", transparency)},
         .is_active = is_active},
        key)});
  };
  constexpr double kSolid = 0.7, kLight = 0.25, kLightest = 0.1;
  const ConvexPolygon& polygon = *params_.polygon;
  draw("gut", label, "obst_", polygon.corners(), kSolid);
  if (params_.draws_least) {
    draw("mid", label + "_mid_poly", "buff_min_", BufferedCorners(polygon, params_.least()),
         kLight);
  }
  if (params_.draws_free) {
    draw("rim", label + "_rim_poly", "buff_max_", BufferedCorners(polygon, params_.free()),
         kLightest);
  }
}

std::optional<std::string> BHV_AvoidObstacle::Macro(std::string_view name,
                                                    const VehicleState& state) const {
  const std::string& id = params_.id.empty() ? params_.label : params_.id;
  if (name == "OID") return id;
  if (name == "OIDX") {  // 7 of rock_7
    const std::size_t mark = id.rfind('_');
    return mark == std::string::npos ? "" : id.substr(mark + 1);
  }
  if (name == "MINU_CPA") return MacroNumber(params_.least());
  if (name == "MAXU_CPA") return MacroNumber(params_.free());
  if (!params_.polygon) return std::nullopt;
  if (name == "CPA") return MacroNumber(passage_.reported);
  if (name == "RNG") return MacroNumber(Range(state));
  const double bearing = BearingTo(state.place(), params_.polygon->Center());
  const double relative = WrapAngle(bearing - state.nav.yaw);
  if (name == "BNG") return MacroNumber(MoosHeadingFromYaw(bearing));
  if (name == "RBNG") return MacroNumber(MoosHeadingFromYaw(relative));
  if (name == "SIDE") return relative > 0.0 ? "star" : "port";
  if (name == "SLOCK") {  // the vehicle's side of the obstacle
    using Side = Passage::Side;
    return passage_.side == Side::kOpen ? "" : passage_.side == Side::kStarboard ? "port" : "star";
  }
  return std::nullopt;
}

LIMPET_REGISTER_BEHAVIOR(BHV_AvoidObstacle);

/// Names under which missions of MOOS-IvP know this behavior, by their age.
using BHV_AvoidObstacleV24 = BHV_AvoidObstacle;
LIMPET_REGISTER_BEHAVIOR(BHV_AvoidObstacleV24);
using BHV_AvoidObstacleV21 = BHV_AvoidObstacle;
LIMPET_REGISTER_BEHAVIOR(BHV_AvoidObstacleV21);
using BHV_AvoidObstacleX = BHV_AvoidObstacle;
LIMPET_REGISTER_BEHAVIOR(BHV_AvoidObstacleX);

}  // namespace limpet
