// SPDX-License-Identifier: MIT
#include "limpet/report/run_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <nlohmann/json.hpp>

#include "limpet/scoring/verdict.hpp"

namespace limpet {
namespace {

using Json = nlohmann::json;

std::optional<double> NumberIn(const Json& object, const char* key) {
  const Json& value = object.at(key);
  return value.is_null() ? std::nullopt : std::optional<double>(value.get<double>());
}

Eigen::Vector3d PointIn(const Json& object, const char* key) {
  const Json& value = object.at(key);
  return {value.at(0).get<double>(), value.at(1).get<double>(), value.at(2).get<double>()};
}

void AddOpis(SessionStatistics& to, const Json& session) {
  for (const Json& opi : session.at("opis")) {
    OpiStatistics& stats = to.opis[opi.at("truth")];
    const Eigen::Vector3d sd = PointIn(opi, "slam_sd_m");
    stats.found.Add(true);
    stats.error_m.Add(NumberIn(opi, "error_m"));
    stats.aligned_error_m.Add(NumberIn(opi, "aligned_error_m"));
    stats.centroid_error_m.Add(
        (PointIn(opi, "map_centroid_ned_m") - PointIn(opi, "truth_ned_m")).norm());
    stats.sd_horizontal_m.Add(std::sqrt(0.5 * (sd.x() * sd.x() + sd.y() * sd.y())));
    stats.sd_vertical_m.Add(sd.z());
  }
  for (const Json& name : session.at("missed"))
    to.opis[name.get<std::string>()].found.Add(false);
}

/// True if every status is right and nothing was decided about nothing.
bool AddStatuses(SessionStatistics& to, const Json& session) {
  bool is_right = true;
  for (const Json& change : session.at("changes")) {
    const bool is_about_nothing = change.at("truth").is_null();
    const bool is_this_right = !is_about_nothing && change.at("expected") == change.at("decided");
    is_right = is_right && is_this_right;
    if (is_about_nothing) continue;
    StatusStatistics& stats = to.statuses[change.at("truth")];
    stats.expected =
        change.at("expected").is_string() ? change.at("expected").get<std::string>() : "";
    stats.right.Add(is_this_right);
    stats.probability.Add(NumberIn(change, "probability"));
  }
  return is_right;
}

void AddPaths(SessionStatistics& to, const Json& session) {
  for (const Json& level : session.at("coverage")) {
    to.seabed_path_m[level.at("level")].Add(NumberIn(level, "path_m"));
  }
  for (const Json& level : session.at("detectable")) {
    to.band_path_m[level.at("level")].Add(NumberIn(level, "path_m"));
  }
  to.path_m.Add(NumberIn(session, "path_m"));
  to.duration_s.Add(NumberIn(session, "duration_s"));
  to.realtime_factor.Add(NumberIn(session, "realtime_factor"));
  if (session.contains("prior_opis_seen_path_m")) {
    to.prior_opis_seen_path_m.Add(NumberIn(session, "prior_opis_seen_path_m"));
  }
}

void AddNavigation(SessionStatistics& to, const Json& nav) {
  to.position_rmse_m.Add(NumberIn(nav, "position_rmse_m"));
  to.aligned_rmse_m.Add(NumberIn(nav, "aligned_rmse_m"));
  to.final_error_m.Add(NumberIn(nav, "final_error_m"));
  to.dead_reckoning_final_error_m.Add(NumberIn(nav, "dead_reckoning_final_error_m"));
  to.nees.Add(NumberIn(nav, "nees_mean"));
}

/// Adds one session; true if nothing at all went wrong in it, as far as anybody knows.
bool AddSession(SessionStatistics& to, const Json& session) {
  if (!session.value("truth", true)) {
    to.duration_s.Add(NumberIn(session, "duration_s"));
    return false;
  }
  AddPaths(to, session);
  AddNavigation(to, session.at("nav"));
  AddOpis(to, session);
  const auto home_error = NumberIn(session, "home_error_m");
  const bool is_home = session.at("ended") == "home" && home_error && *home_error <= kHomeRadius;
  const bool is_covered = session.at("covered").get<double>() >= 0.95 &&
                          session.at("detected_band").get<double>() >= 0.95;
  const bool is_none_missed = session.at("missed").empty();
  const bool is_none_invented = session.at("false").empty();
  const auto& opis = session.at("opis");
  const bool is_placed =
      is_none_missed && std::all_of(opis.begin(), opis.end(), [](const Json& opi) {
        return opi.at("error_m").get<double>() <= kGoodError;
      });
  to.home_error_m.Add(home_error);
  to.home.Add(is_home);
  to.covered.Add(is_covered);
  to.none_missed.Add(is_none_missed);
  to.none_invented.Add(is_none_invented);
  to.all_within_1m.Add(is_placed);
  bool is_right = true;
  if (session.contains("changes")) {
    is_right = AddStatuses(to, session);
    to.statuses_right.Add(is_right);
  }
  return is_home && is_covered && is_none_invented && is_placed && is_right;
}

}  // namespace

void Statistic::Add(const std::optional<double>& sample) {
  ++asked_;
  if (sample) samples_.push_back(*sample);
}

double Statistic::mean() const {
  if (samples_.empty()) return 0.0;
  return std::accumulate(samples_.begin(), samples_.end(), 0.0) /
         static_cast<double>(samples_.size());
}

double Statistic::sd() const {
  if (samples_.size() < 2) return 0.0;
  const double centre = mean();
  double squares = 0.0;
  for (const double sample : samples_)
    squares += (sample - centre) * (sample - centre);
  return std::sqrt(squares / static_cast<double>(samples_.size() - 1));
}

std::optional<Error> RunStatistics::Add(const std::string& report_json) {
  RunStatistics next = *this;
  try {
    const Json report = Json::parse(report_json);
    next.mission = report.at("mission");
    bool is_flawless = !report.at("sessions").empty();
    for (const auto& [name, session] : report.at("sessions").items()) {
      const bool is_good = AddSession(next.sessions[name], session);
      is_flawless = is_flawless && is_good;
    }
    next.flawless.Add(is_flawless);
    ++next.runs;
  } catch (const Json::exception& error) {
    return Error{error.what()};
  }
  *this = std::move(next);
  return std::nullopt;
}

}  // namespace limpet
