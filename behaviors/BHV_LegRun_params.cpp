// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <utility>

#include "behaviors/BHV_LegRun.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/waypoints/map_params.hpp"
#include "limpet/waypoints/point_list.hpp"

namespace limpet {
namespace {

using LegParams = BHV_LegRun::Params;
using LegChange = std::function<void(LegPlan&)>;
/// The change that a line's value makes; nothing if it cannot be read.
using LegReader = std::function<std::optional<LegChange>(std::string_view)>;

/// One key of a leg, and its other names.
struct LegKey {
  std::string name;
  std::vector<std::string> others{};
  bool is_place = false;
};

void DescribeEdit(ParamCollector& visit, LegParams& params, const LegKey& key, const char* form,
                  const char* help, const LegReader& read) {
  std::vector<std::string> names = key.others;
  names.push_back(key.name);
  visit.Parsed(key.name.c_str(), form, help, "",
               [&params, read, names, is_place = key.is_place](std::string_view text) {
                 if (text.empty()) return true;
                 std::optional<LegChange> change = read(text);
                 if (!change) return false;
                 params.edits.push_back({names, is_place, *std::move(change)});
                 return true;
               });
  for (const std::string& other : key.others) {
    visit.Also({other.c_str()});
  }
}

/// Reads one number of a range, for what `apply` makes of it.
LegReader NumberOf(double low, double high, const std::function<void(LegPlan&, double)>& apply) {
  return [=](std::string_view text) -> std::optional<LegChange> {
    const auto number = ParseNumber(text);
    if (!number || *number < low || *number > high) return std::nullopt;
    return [apply, value = *number](LegPlan& plan) { apply(plan, value); };
  };
}

/// `x,y`, `x:y` or `x=1,y=2`.
std::optional<MapPoint> ReadLegPoint(std::string_view text) {
  std::string written(text);
  std::ranges::replace(written, ':', ',');
  return ParsePoint(written);
}

/// `x:y:angle:length` or `x=4,y=6,ang=64,len=80`.
std::optional<LegChange> ReadWholeLeg(std::string_view text) {
  constexpr std::array<std::string_view, 4> kNames{"x", "y", "ang", "len"};
  const bool is_named = text.find('=') != std::string_view::npos;
  const std::vector<std::string> parts = Split(text, is_named ? ',' : ':');
  if (parts.size() != kNames.size()) return std::nullopt;
  std::array<std::optional<double>, 4> values;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string_view part = parts[i];
    const std::size_t equals = part.find('=');
    if (is_named != (equals != std::string_view::npos)) return std::nullopt;
    const auto named = [&](std::string_view name) {
      return EqualsIgnoringCase(Trim(part.substr(0, equals)), name);
    };
    const auto place = is_named ? std::ranges::find_if(kNames, named) : kNames.begin() + i;
    if (place == kNames.end()) return std::nullopt;
    values.at(static_cast<std::size_t>(place - kNames.begin())) =
        ParseNumber(Trim(is_named ? part.substr(equals + 1) : part));
  }
  if (!std::ranges::all_of(values, [](const auto& value) { return value.has_value(); }) ||
      *values[3] <= 0.0) {
    return std::nullopt;
  }
  return [center = MapPoint{.x = *values[0], .y = *values[1]},
          bearing = Radians::FromTextUnit(*values[2]).value(), length = *values[3]](LegPlan& plan) {
    plan.Lay(center, {.bearing = bearing, .distance = length});
  };
}

void DescribeWhere(ParamCollector& visit, LegParams& params) {
  const auto end = [](std::size_t index) -> LegReader {
    return [index](std::string_view text) -> std::optional<LegChange> {
      const auto point = ReadLegPoint(text);
      if (!point) return std::nullopt;
      return [index, point](LegPlan& plan) { plan.SetEnd(index, *point); };
    };
  };
  DescribeEdit(visit, params, {"p1", {"vx1"}, true}, "x,y",
               "One end of the leg, where the first leg goes: x east, y north of the datum [m]",
               end(0));
  DescribeEdit(visit, params, {"p2", {"vx2"}, true}, "x,y", "The other end [m]", end(1));
  DescribeEdit(visit, params, {"leg", {"full_leg"}, true}, "x:y:angle:length",
               "Both: the leg's middle [m], its bearing from p1 to p2 [deg], its length [m]",
               ReadWholeLeg);
  DescribeEdit(visit, params, {"shift_pt", {"shift_point"}}, "x,y", "Moves its middle there [m]",
               [](std::string_view text) -> std::optional<LegChange> {
                 const auto point = ReadLegPoint(text);
                 if (!point) return std::nullopt;
                 return [point](LegPlan& plan) {
                   if (plan.is_set())
                     plan.Lay(*point, {.bearing = plan.bearing(), .distance = plan.length()});
                 };
               });
}

void DescribeLegSize(ParamCollector& visit, LegParams& params) {
  const auto length = [](bool adds) {
    return [adds](LegPlan& plan, double value) {
      if (!plan.is_set()) return;
      plan.Lay(plan.center(),
               {.bearing = plan.bearing(), .distance = value + (adds ? plan.length() : 0.0)});
    };
  };
  const auto angle = [](bool adds) {
    return [adds](LegPlan& plan, double degrees) {
      if (!plan.is_set()) return;
      const double value = Radians::FromTextUnit(degrees).value();
      plan.Lay(plan.center(),
               {.bearing = value + (adds ? plan.bearing() : 0.0), .distance = plan.length()});
    };
  };
  DescribeEdit(visit, params, {"leg_len", {"leg_length"}}, "1 to 100000 m",
               "About its middle, so long", NumberOf(1.0, 1e5, length(false)));
  DescribeEdit(visit, params, {"leg_len_mod", {"leg_length_mod"}}, "-100000 to 100000 m",
               "So much longer than now; not below 1 m", NumberOf(-1e5, 1e5, length(true)));
  DescribeEdit(visit, params, {"leg_ang", {"leg_angle"}}, "-360 to 360 deg",
               "About its middle, on this bearing from p1 to p2",
               NumberOf(-360.0, 360.0, angle(false)));
  DescribeEdit(visit, params, {"leg_ang_mod", {"leg_angle_mod"}}, "-360 to 360 deg",
               "Turned clockwise from where it is", NumberOf(-360.0, 360.0, angle(true)));
}

/// What of a turn is a number: its key after `turn_`, its range, and how it is set.
struct TurnNumber {
  const char* name;
  double low, high;
  const char* form;
  const char* help;
  void (*set)(LegTurn&, double value, bool adds);
};

void SetRadius(LegTurn& turn, double value, bool adds) {
  turn.radius = std::max(0.0, value + (adds ? turn.radius : 0.0));
}
void SetExtension(LegTurn& turn, double value, bool adds) {
  turn.extension = std::max(0.0, value + (adds ? turn.extension : 0.0));
}
void SetBias(LegTurn& turn, double percent, bool adds) {
  turn.bias = std::clamp(0.01 * percent + (adds ? turn.bias : 0.0), -1.0, 1.0);
}

constexpr std::array<TurnNumber, 3> kTurnNumbers{
    {{"rad", 0.1, 1e4, "0.1 to 10000 m", "Radius of the turn", SetRadius},
     {"ext", 0.0, 1e4, "0 to 10000 m", "Straight on before the turn", SetExtension},
     {"bias", -100.0, 100.0, "-100 to 100 %",
      "The loop lies to where the turn first swings by so much of its radius", SetBias}}};

/// `turn1`, `turn2` and `turn`, which is both.
constexpr std::array<std::pair<const char*, std::array<bool, 2>>, 3> kTurns{
    {{"turn1", {true, false}}, {"turn2", {false, true}}, {"turn", {true, true}}}};

void DescribeTurnOf(ParamCollector& visit, LegParams& params, const std::string& which,
                    const std::array<bool, 2>& ends) {
  const auto each = [ends](LegPlan& plan, const auto& change) {
    for (std::size_t end = 0; end < ends.size(); ++end) {
      if (ends.at(end)) change(plan.turn(end));
    }
  };
  for (const TurnNumber& number : kTurnNumbers) {
    const auto set = [each, change = number.set](bool adds) {
      return [each, change, adds](LegPlan& plan, double value) {
        each(plan, [&](LegTurn& turn) { change(turn, value, adds); });
      };
    };
    DescribeEdit(visit, params, {which + "_" + number.name}, number.form, number.help,
                 NumberOf(number.low, number.high, set(false)));
    DescribeEdit(visit, params, {which + "_" + number.name + "_mod"}, "-10000 to 10000",
                 "So much more than now", NumberOf(-1e4, 1e4, set(true)));
  }
  DescribeEdit(visit, params, {which + "_dir"}, "port, star, left, right or starboard",
               "Which way its loop goes round; else to port",
               [each](std::string_view text) -> std::optional<LegChange> {
                 const auto is_port = ParseIsPort(text);
                 if (!is_port) return std::nullopt;
                 return [each, is_port](LegPlan& plan) {
                   each(plan, [&](LegTurn& turn) { turn.is_port = *is_port; });
                 };
               });
}

/// `1.5, 2:0.8`: a leg at 1.5 m/s, then two at 0.8; `clear`, `reset`, `replace, ...`.
bool ReadLegSpeeds(std::string_view text, LegParams& params) {
  constexpr double kMost = 100.0;
  constexpr int kMostLegs = 10'000;
  if (EqualsIgnoringCase(text, "reset")) return true;
  std::vector<double> speeds;
  for (const std::string& part : Split(text, ',')) {
    const std::string_view written = Trim(part);
    const bool is_word = EqualsIgnoringCase(written, "clear") ||
                         EqualsIgnoringCase(written, "replace") || written.empty();
    if (is_word) continue;
    const std::size_t colon = written.find(':');
    const bool is_many = colon != std::string_view::npos;
    const auto legs = is_many ? ParseInteger(Trim(written.substr(0, colon))) : 1;
    const auto speed = ParseNumber(Trim(is_many ? written.substr(colon + 1) : written));
    if (!legs || *legs < 1 || *legs > kMostLegs || !speed || *speed < 0.0 || *speed > kMost) {
      return false;
    }
    speeds.insert(speeds.end(), static_cast<std::size_t>(*legs), *speed);
  }
  params.leg_speeds = std::move(speeds);
  return true;
}

void DescribeLegSpeeds(ParamCollector& visit, LegParams& params) {
  visit("speed", params.speed, "Speed on the way",
        InRange(MetersPerSecond(0.0), MetersPerSecond(100.0)));
  visit.Parsed("leg_spds", "1.5, 2:0.8 in mps; clear or reset",
               "Speeds of single legs, from the second one on; 2:0.8 is two of them", "",
               [&params](std::string_view text) { return ReadLegSpeeds(text, params); });
  visit("leg_spds_repeat", params.repeats_speeds, "After the last of them the first again");
  visit("leg_spds_onturn", params.keeps_speed_in_turns,
        "The leg's speed counts in the turn after it, too");
}

void DescribeLegFlags(ParamCollector& visit, LegParams& params) {
  const auto flags = [&visit](const char* name, std::vector<Flag>& list, const char* help,
                              std::initializer_list<const char*> others) {
    DescribeFlags(visit, name, list, help);
    visit.Also(others);
  };
  flags("leg_endflag", params.leg_flags, "Posted at the end of each leg",
        {"leg_end_flag", "wptflag"});
  flags("leg1_endflag", params.leg1_flags, "Posted at p1", {"leg1_end_flag"});
  flags("leg2_endflag", params.leg2_flags, "Posted at p2", {"leg2_end_flag"});
  flags("midlegflag", params.mid_leg_flags, "Posted on each leg but the first, after mid_leg_pct",
        {"mid_leg_flag", "midflag"});
  visit("mid_leg_pct", params.mid_leg, "Share of the leg [%]", InRange(0.0, 100.0));
  visit.Also({"mid_pct"});
  flags("turn_endflag", params.turn_flags, "Posted at the end of each turn", {"turn_end_flag"});
  flags("turn1_endflag", params.turn1_flags, "Of the turn at p1", {"turn1_end_flag"});
  flags("turn2_endflag", params.turn2_flags, "Of the turn at p2", {"turn2_end_flag"});
  flags("midturnflag", params.mid_turn_flags, "Posted in each turn, after mid_turn_pct",
        {"mid_turn_flag"});
  visit("mid_turn_pct", params.mid_turn, "Share of the turn [%]", InRange(0.0, 100.0));
  DescribeFlags(visit, "cycleflag", params.cycle_flags, "Posted after each two legs");
}

}  // namespace

void BHV_LegRun::Params::Describe(ParamCollector& visit) {
  DescribeWhere(visit, *this);
  DescribeLegSize(visit, *this);
  for (const auto& [which, ends] : kTurns) {
    DescribeTurnOf(visit, *this, which, ends);
  }
  DescribeEdit(visit, *this, {"turn_rad_min"}, "0.1 to 10000 m", "No turn is tighter; else 2 m",
               NumberOf(0.1, 1e4, &LegPlan::SetLeastRadius));
  DescribeEdit(visit, *this, {"turn_pt_gap"}, "0.5 to 90 deg",
               "Turned from one point of a turn to the next; else 20 deg",
               NumberOf(0.5, 90.0, [](LegPlan& plan, double degrees) {
                 plan.SetPointGap(Radians::FromTextUnit(degrees).value());
               }));
  visit.Choice("init_leg_mode", first_leg,
               "First to p1 (fixed, resume), to the nearer or to the farther end",
               {"fixed", "resume", "close_turn", "far_turn"});
  DescribeRepeats(visit, repeats);
  DescribeCapture(visit, capture);
  DescribeLead(visit, lead);
  DescribeLegSpeeds(visit, *this);
  DescribeLegFlags(visit, *this);
  DescribeHints(visit, hints);
  DescribePatience(visit, patience);
  visit.WithoutEffect({"id", "lane", "adjust_turn", "warn_overshoot", "legflag", "leg_length_min",
                       "wpt_status_var"});
}

}  // namespace limpet
