// SPDX-License-Identifier: MIT
#include "limpet/report/report_json.hpp"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

namespace limpet {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson Rounded(double value, double scale) {
  if (!std::isfinite(value)) return nullptr;
  return std::round(value * scale) / scale + 0.0;  // + 0.0 turns -0 into 0
}
OrderedJson Length(double metres) { return Rounded(metres, 1e3); }
OrderedJson Share(double share) { return Rounded(share, 1e4); }
OrderedJson Time(double seconds) { return Rounded(seconds, 1e2); }
OrderedJson Optional(const std::optional<double>& value, OrderedJson (*write)(double)) {
  return value ? write(*value) : OrderedJson(nullptr);
}
OrderedJson PointJson(const Eigen::Vector3d& p) {
  return {Length(p.x()), Length(p.y()), Length(p.z())};
}

OrderedJson Levels(const std::vector<CoverageLevel>& levels, double lowest) {
  OrderedJson list = OrderedJson::array();
  for (const CoverageLevel& level : levels) {
    if (level.level < lowest) continue;
    list.push_back({{"level", level.level},
                    {"path_m", Optional(level.path_m, Length)},
                    {"time_s", Optional(level.time_s, Time)}});
  }
  return list;
}

OrderedJson Navigation(const NavScore& nav) {
  return {{"position_rmse_m", Optional(nav.position_rmse_m, Length)},
          {"aligned_rmse_m", Optional(nav.aligned_rmse_m, Length)},
          {"final_error_m", Optional(nav.final_error_m, Length)},
          {"dead_reckoning_final_error_m", Optional(nav.dead_reckoning_final_error_m, Length)},
          {"nees_mean", Optional(nav.nees_mean, Share)}};
}

/// The object's radius as the vehicle estimates it; null where it does not.
OrderedJson RadiusJson(const OpiBelief& opi) {
  return opi.object.size ? OrderedJson(Length(opi.object.size->radius)) : OrderedJson(nullptr);
}

OrderedJson Opis(const std::vector<OpiScore>& opis) {
  OrderedJson list = OrderedJson::array();
  for (const OpiScore& opi : opis) {
    list.push_back({{"truth", opi.truth},
                    {"truth_ned_m", PointJson(opi.truth_W)},
                    {"slam_ned_m", PointJson(opi.belief.object.p_W)},
                    {"slam_sd_m", PointJson(opi.belief.object.sd_W())},
                    {"map_centroid_ned_m", PointJson(opi.belief.centroid_W)},
                    {"map_sd_m", PointJson(opi.belief.centroid_sd_W)},
                    {"error_m", Length(opi.error_m)},
                    {"aligned_error_m", Length(opi.aligned_error_m)},
                    {"looks", opi.belief.looks},
                    {"radius_m", RadiusJson(opi.belief)}});
  }
  return list;
}

OrderedJson Opis(const std::vector<OpiBelief>& opis) {
  OrderedJson list = OrderedJson::array();
  for (const OpiBelief& opi : opis) {
    list.push_back({{"truth", nullptr},
                    {"truth_ned_m", nullptr},
                    {"slam_ned_m", PointJson(opi.object.p_W)},
                    {"slam_sd_m", PointJson(opi.object.sd_W())},
                    {"map_centroid_ned_m", PointJson(opi.centroid_W)},
                    {"map_sd_m", PointJson(opi.centroid_sd_W)},
                    {"error_m", nullptr},
                    {"aligned_error_m", nullptr},
                    {"looks", opi.looks},
                    {"radius_m", RadiusJson(opi)},
                    {"class", opi.object.color},
                    {"probability", Share(opi.posterior.present())}});
  }
  return list;
}

OrderedJson InventedOpis(const std::vector<OpiBelief>& opis) {
  OrderedJson list = OrderedJson::array();
  for (const OpiBelief& opi : opis) {
    list.push_back({{"ned_m", PointJson(opi.object.p_W)},
                    {"class", opi.object.color},
                    {"probability", Share(opi.posterior.present())}});
  }
  return list;
}

OrderedJson PosteriorJson(const StatusPosterior& posterior) {
  OrderedJson out = OrderedJson::object();
  for (const auto& [status, probability] : posterior.shares())
    out[NameOf(status)] = Share(probability);
  return out;
}

OrderedJson Changes(const std::vector<ChangeScore>& changes) {
  OrderedJson list = OrderedJson::array();
  for (const ChangeScore& change : changes) {
    list.push_back({{"truth", change.truth ? OrderedJson(*change.truth) : OrderedJson(nullptr)},
                    {"expected", change.expected ? OrderedJson(NameOf(*change.expected))
                                                 : OrderedJson(nullptr)},
                    {"decided", NameOf(change.decided)},
                    {"probability", change.probability ? OrderedJson(Share(*change.probability))
                                                       : OrderedJson(nullptr)},
                    {"moved_probability", change.moved_probability
                                              ? OrderedJson(Share(*change.moved_probability))
                                              : OrderedJson(nullptr)},
                    {"ned_m", change.p_W ? PointJson(*change.p_W) : OrderedJson(nullptr)},
                    {"posterior",
                     change.posterior ? PosteriorJson(*change.posterior) : OrderedJson(nullptr)}});
  }
  return list;
}

/// `value` where the truth is known, else null.
OrderedJson IfJudged(const SessionScore& session, OrderedJson value) {
  return session.has_truth ? std::move(value) : OrderedJson(nullptr);
}

/// Times in seconds since the session's start; `to_s` null: it stood at the end.
OrderedJson Warnings(const SessionScore& session) {
  OrderedJson list = OrderedJson::array();
  const auto since_start = [&session](Seconds time) {
    return Time((time - session.begun.value_or(time)).value());
  };
  for (const WarningRecord& warning : session.warnings) {
    list.push_back({{"app", warning.app},
                    {"id", warning.id},
                    {"severity", NameOf(warning.severity)},
                    {"text", warning.text},
                    {"from_s", since_start(warning.from)},
                    {"to_s", warning.to ? since_start(*warning.to) : OrderedJson(nullptr)}});
  }
  return list;
}

/// What the vehicle itself says; null if it said nothing.
OrderedJson Water(const SessionScore& session) {
  if (!session.water) return nullptr;
  const WaterScore& water = *session.water;
  return {{"visibility_m", Length(water.visibility.visibility.value())},
          {"sd_m", Length(water.visibility.sd.value())},
          {"seen_from_height_m", Length(water.seen_from_m)},
          {"believed_coverage",
           {{"seabed", Share(water.believed.seabed)},
            {"band", Share(water.believed.band)},
            {"band_top", Share(water.believed.band_top)}}}};
}

/// What the vehicle itself says, where it sets to; null if it said nothing.
OrderedJson Current(const SessionScore& session) {
  if (!session.current) return nullptr;
  return {{"north_mps", Length(session.current->north)},
          {"east_mps", Length(session.current->east)},
          {"sd_mps", Length(session.current->sd)}};
}

/// What the vehicle itself says; null without a battery.
OrderedJson Energy(const SessionScore& session) {
  if (!session.energy) return nullptr;
  const EnergyRecord& energy = *session.energy;
  return {{"used_wh", Length(energy.last.used_wh)},
          {"home_wh", Length(energy.home_wh)},
          {"left_wh", Length(energy.last.left_wh)},
          {"reserve_wh", Length(energy.last.reserve_wh)},
          {"least_spare_wh", Length(energy.least_spare_wh)}};
}

OrderedJson Phases(const std::vector<PhaseTime>& phases) {
  OrderedJson out = OrderedJson::object();
  for (const PhaseTime& phase : phases)
    out[phase.phase] = Time(phase.seconds);
  return out;
}

/// Unseen shares of the seabed and of the band, of the latter with why.
OrderedJson UnseenShare(const UnseenScore& unseen) {
  OrderedJson reasons = OrderedJson::object();
  for (std::size_t i = 0; i < kWaysUnseen; ++i)
    reasons[NameOf(static_cast<WhyUnseen>(i))] = Share(unseen.band_by_reason[i]);
  return {{"bottom", Share(unseen.bottom)},
          {"band", Share(unseen.band)},
          {"reason",
           unseen.band > 0.0 ? OrderedJson(NameOf(unseen.main_reason())) : OrderedJson(nullptr)},
          {"band_by_reason", reasons}};
}

/// Null where no area was told.
OrderedJson Bound(const SessionScore& session) {
  if (!session.bound) return nullptr;
  return {{"area_m2", Length(session.bound->area_m2)},
          {"swath_m", Length(session.bound->swath_m)},
          {"path_m", Optional(session.bound->path_m(), Length)}};
}

/// Null where no lanes were reckoned.
OrderedJson Lanes(const SessionScore& session) {
  if (!session.lanes) return nullptr;
  const LanesScore& lanes = *session.lanes;
  return {{"passes", lanes.passes},
          {"direction_deg", Time(lanes.direction_deg)},
          {"path_m", Length(lanes.path_m)},
          {"time_s", Time(lanes.time_s)},
          {"coverage", Levels(lanes.seabed, 0.90)},
          {"detectable", Levels(lanes.band, 0.95)}};
}

/// How near the vehicle came to each.
OrderedJson ObstaclesPassed(const SessionScore& session) {
  OrderedJson out = OrderedJson::array();
  for (const ObstacleScore& passed : session.obstacles) {
    out.push_back({{"name", passed.name}, {"distance_m", Length(passed.distance_m)}});
  }
  return out;
}

/// The least of those; null without obstacles.
OrderedJson NearestObstacle(const SessionScore& session) {
  if (session.obstacles.empty()) return nullptr;
  return Length(std::ranges::min(session.obstacles, {}, &ObstacleScore::distance_m).distance_m);
}

/// Null where nobody can say.
OrderedJson OfFences(const SessionScore& session, double FenceScore::*way) {
  return session.fences ? OrderedJson(Length(*session.fences.*way)) : OrderedJson(nullptr);
}

/// What each generator of options won.
OrderedJson Wins(const std::vector<OptionWins>& wins) {
  OrderedJson out = OrderedJson::object();
  for (const OptionWins& of : wins)
    out[of.source] = {{"decisions", of.decisions}, {"path_m", Length(of.path_m)}};
  return out;
}

OrderedJson Session(const SessionScore& session) {
  OrderedJson out = {
      {"coverage", IfJudged(session, Levels(session.coverage.seabed, 0.90))},
      {"detectable", IfJudged(session, Levels(session.coverage.band, 0.95))},
      {"covered", IfJudged(session, Share(session.coverage.covered))},
      {"detected_band", IfJudged(session, Share(session.coverage.detected_band))},
      {"bound", Bound(session)},
      {"lanes", Lanes(session)},
      {"unseen_share", IfJudged(session, UnseenShare(session.coverage.unseen))},
      {"path_m", IfJudged(session, Length(session.path_m))},
      {"survey_path_m", Optional(session.survey_path_m, Length)},
      {"options_won", Wins(session.wins)},
      {"duration_s", Time(session.duration_s)},
      {"phase_s", Phases(session.phases)},
      {"wall_s", Optional(session.wall_s, Length)},
      {"realtime_factor", Optional(session.realtime_factor(), Time)},
      {"ended", session.ended},
      {"home_error_m", Optional(session.home_error_m, Length)},
      {"outside_region_m", OfFences(session, &FenceScore::outside_region_m)},
      {"inside_zone_m", OfFences(session, &FenceScore::inside_zone_m)},
      {"obstacle_distance_m", NearestObstacle(session)},
      {"obstacles", IfJudged(session, ObstaclesPassed(session))},
      {"nav", Navigation(session.nav)},
      {"opis", session.has_truth ? Opis(session.opis.found) : Opis(session.opis.reported)},
      {"missed", IfJudged(session, session.opis.missed)},
      {"false", IfJudged(session, InventedOpis(session.opis.invented))}};
  out["water"] = Water(session);
  out["current"] = Current(session);
  out["energy"] = Energy(session);
  out["warnings"] = Warnings(session);
  if (!session.former.empty()) {
    out["prior_opis_seen_path_m"] = Optional(session.coverage.prior_opis_seen_path_m, Length);
    out["changes"] = Changes(session.opis.changes);
  }
  if (!session.has_truth) {
    out["truth"] = false;
    out["estimated_path_m"] = Length(session.path_m);
  }
  return out;
}

}  // namespace

std::string ReportJson(const RunScore& run) {
  const ReportSettings& settings = run.settings;
  const auto footprint = settings.footprint_m();
  const auto centimetres = [](double metres) { return Rounded(metres, 1e2); };
  OrderedJson report = {{"limpet", settings.version},
                        {"mission", settings.mission},
                        {"seed", settings.seed},
                        {"settings",
                         {{"planner", settings.planner},
                          {"gain", settings.gain},
                          {"camera", settings.camera},
                          {"footprint_m", {centimetres(footprint[0]), centimetres(footprint[1])}},
                          {"object_height_max_m", settings.object_height_max_m}}},
                        {"sessions", OrderedJson::object()}};
  for (const SessionScore& session : run.sessions) {
    report["sessions"][session.name] = Session(session);
  }
  return report.dump(2) + "\n";
}

}  // namespace limpet
