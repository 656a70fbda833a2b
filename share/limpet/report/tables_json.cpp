// SPDX-License-Identifier: MIT
#include <cmath>

#include <nlohmann/json.hpp>

#include "limpet/core/four_decimals.hpp"
#include "limpet/report/paper_tables.hpp"

namespace limpet {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson FourDigits(double value) { return ToFourDecimals(value) + 0.0; }

OrderedJson ToJson(const Statistic& statistic) {
  const bool has_samples = statistic.count() > 0;
  return {{"mean", has_samples ? FourDigits(statistic.mean()) : OrderedJson(nullptr)},
          {"sd", has_samples ? FourDigits(statistic.sd()) : OrderedJson(nullptr)},
          {"count", statistic.count()},
          {"of", statistic.asked()}};
}

OrderedJson ToJson(const Rate& rate) { return {{"good", rate.good}, {"of", rate.of}}; }

OrderedJson ToJson(const std::map<double, Statistic>& levels) {
  OrderedJson list = OrderedJson::array();
  for (const auto& [level, statistic] : levels) {
    list.push_back({{"level", level}, {"path_m", ToJson(statistic)}});
  }
  return list;
}

OrderedJson ToJson(const SessionStatistics& session) {
  OrderedJson opis = OrderedJson::object(), statuses = OrderedJson::object();
  for (const auto& [name, opi] : session.opis) {
    opis[name] = {{"found", ToJson(opi.found)},
                  {"error_m", ToJson(opi.error_m)},
                  {"aligned_error_m", ToJson(opi.aligned_error_m)},
                  {"map_centroid_error_m", ToJson(opi.centroid_error_m)},
                  {"sd_horizontal_m", ToJson(opi.sd_horizontal_m)},
                  {"sd_vertical_m", ToJson(opi.sd_vertical_m)}};
  }
  for (const auto& [name, status] : session.statuses) {
    statuses[name] = {{"expected", status.expected},
                      {"right", ToJson(status.right)},
                      {"probability", ToJson(status.probability)}};
  }
  return {{"coverage", ToJson(session.seabed_path_m)},
          {"detectable", ToJson(session.band_path_m)},
          {"prior_opis_seen_path_m", ToJson(session.prior_opis_seen_path_m)},
          {"path_m", ToJson(session.path_m)},
          {"duration_s", ToJson(session.duration_s)},
          {"realtime_factor", ToJson(session.realtime_factor)},
          {"position_rmse_m", ToJson(session.position_rmse_m)},
          {"aligned_rmse_m", ToJson(session.aligned_rmse_m)},
          {"final_error_m", ToJson(session.final_error_m)},
          {"dead_reckoning_final_error_m", ToJson(session.dead_reckoning_final_error_m)},
          {"nees_mean", ToJson(session.nees)},
          {"home_error_m", ToJson(session.home_error_m)},
          {"home", ToJson(session.home)},
          {"covered", ToJson(session.covered)},
          {"none_missed", ToJson(session.none_missed)},
          {"none_invented", ToJson(session.none_invented)},
          {"all_within_1m", ToJson(session.all_within_1m)},
          {"statuses_right", ToJson(session.statuses_right)},
          {"opis", opis},
          {"statuses", statuses}};
}

}  // namespace

std::string TablesJson(const RunStatistics& runs, const std::string& options) {
  OrderedJson sessions = OrderedJson::object();
  for (const auto& [name, session] : runs.sessions)
    sessions[name] = ToJson(session);
  return OrderedJson{{"mission", runs.mission},
                     {"options", options},
                     {"runs", runs.runs},
                     {"failed_seeds", runs.failed},
                     {"flawless", ToJson(runs.flawless)},
                     {"sessions", sessions}}
             .dump(2) +
         "\n";
}

}  // namespace limpet
