// SPDX-License-Identifier: MIT
#include "limpet/report/paper_tables.hpp"

#include <fmt/format.h>

#include "limpet/session/session_order.hpp"

namespace limpet {
namespace {

/// "205.1 ± 7.3", with how often it was reached when not always.
std::string Text(const Statistic& statistic, int decimals = 1) {
  if (statistic.count() == 0) return statistic.asked() > 0 ? "never" : "-";
  std::string text =
      fmt::format("{:.{}f} \u00b1 {:.{}f}", statistic.mean(), decimals, statistic.sd(), decimals);
  if (statistic.count() < statistic.asked()) {
    text += fmt::format(" ({} of {})", statistic.count(), statistic.asked());
  }
  return text;
}

std::string Text(const Rate& rate) {
  return rate.of > 0 ? fmt::format("{} of {}", rate.good, rate.of) : "-";
}

std::string At(const std::map<double, Statistic>& levels, double level) {
  const auto found = levels.find(level);
  return found != levels.end() ? Text(found->second) : "-";
}

/// The paper's path lengths, four runs each [m]: with its object term and without.
struct PaperPaths {
  const char* prior_seen[2];
  const char* at_90[2];
  const char* at_95[2];
};
constexpr PaperPaths kTable4{{"-", "-"},
                             {"424.42 \u00b1 25.82", "383.13 \u00b1 29.03"},
                             {"482.89 \u00b1 41.11", "437.54 \u00b1 39.63"}};
constexpr PaperPaths kTable5{{"55.21 \u00b1 6.23", "194.29 \u00b1 24.92"},
                             {"457.62 \u00b1 32.52", "390.24 \u00b1 25.72"},
                             {"506.21 \u00b1 37.34", "438.46 \u00b1 31.87"}};
constexpr PaperPaths kTable7{
    {"-", "-"}, {"131.06 \u00b1 16.14", "-"}, {"147.68 \u00b1 10.03", "-"}};
constexpr PaperPaths kTable8{{"-", "-"}, {"154.77 \u00b1 9.82", "-"}, {"171.05 \u00b1 16.11", "-"}};

PaperTable PathTable(const std::string& title, const SessionStatistics& session,
                     const PaperPaths& paper, bool is_change) {
  PaperTable table{
      title,
      {"way [m] to", "ours, bottom", "ours, band", "paper, objects and cover", "paper, cover only"},
      {},
      ""};
  if (is_change) {
    table.rows.push_back({"former objects seen", Text(session.prior_opis_seen_path_m), "",
                          paper.prior_seen[0], paper.prior_seen[1]});
  }
  table.rows.push_back({"90 %", At(session.seabed_path_m, 0.90), At(session.band_path_m, 0.90),
                        paper.at_90[0], paper.at_90[1]});
  table.rows.push_back({"95 %", At(session.seabed_path_m, 0.95), At(session.band_path_m, 0.95),
                        paper.at_95[0], paper.at_95[1]});
  table.rows.push_back(
      {"99 %", At(session.seabed_path_m, 0.99), At(session.band_path_m, 0.99), "-", "-"});
  table.note =
      "Mean \u00b1 standard deviation; the paper's are of four runs, and it does not say which "
      "coverage it counts.";
  return table;
}

constexpr PaperPaths kNotInThePaper{{"-", "-"}, {"-", "-"}, {"-", "-"}};

PaperTable PlaceTable(const std::string& session_name, const SessionStatistics& session) {
  const bool is_papers = session_name == "discovery";
  PaperTable table{
      fmt::format("{}laces of the objects, {} session [m]", is_papers ? "Table 2: p" : "P",
                  session_name),
      {"object", "found", "error", "aligned", "map centroid", "sd horizontal", "sd vertical"},
      {},
      ""};
  for (const auto& [name, opi] : session.opis) {
    table.rows.push_back({name, Text(opi.found), Text(opi.error_m, 2), Text(opi.aligned_error_m, 2),
                          Text(opi.centroid_error_m, 2), Text(opi.sd_horizontal_m, 2),
                          Text(opi.sd_vertical_m, 2)});
  }
  if (is_papers) {
    table.rows.push_back({"paper", "4 of 4", "about 0.4, at most 1", "-", "about 0.5",
                          "0.16 to 0.40", "0.26 to 0.65"});
  }
  table.note = fmt::format("{}Errors are 3-D distances from the truth.",
                           is_papers ? "The paper's are of one run. " : "");
  return table;
}

PaperTable StatusTable(const std::string& session_name, const SessionStatistics& session) {
  const bool is_papers = session_name == "change";
  PaperTable table{
      fmt::format("{}tatuses, {} session", is_papers ? "Table 3: s" : "S", session_name),
      {"object", "truth", "right", "probability"},
      {},
      ""};
  for (const auto& [name, status] : session.statuses) {
    table.rows.push_back({name, status.expected, Text(status.right), Text(status.probability, 3)});
  }
  if (is_papers) table.rows.push_back({"paper", "all five", "5 of 5", "0.93 to 0.96"});
  return table;
}

PaperTable RateTable(const RunStatistics& runs) {
  PaperTable table{"How often it went well",
                   {"session", "home within 3 m", "covered", "none missed", "none invented",
                    "all within 1 m", "statuses right"},
                   {},
                   ""};
  for (const auto& [name, s] : runs.sessions) {
    table.rows.push_back({name, Text(s.home), Text(s.covered), Text(s.none_missed),
                          Text(s.none_invented), Text(s.all_within_1m), Text(s.statuses_right)});
  }
  table.note = fmt::format("Flawless in everything: {}. Covered: 95 % of bottom and band.",
                           Text(runs.flawless));
  if (!runs.failed.empty()) {
    table.note += fmt::format(" {} more {} left no report: seed", runs.failed.size(),
                              runs.failed.size() == 1 ? "run" : "runs");
    for (const std::uint64_t seed : runs.failed)
      table.note += fmt::format(" {}", seed);
    table.note += ".";
  }
  return table;
}

PaperTable NavigationTable(const RunStatistics& runs) {
  PaperTable table{"Navigation and speed",
                   {"session", "rmse [m]", "aligned [m]", "at the end [m]", "dead reckoning [m]",
                    "NEES (ideal 3)", "real time x"},
                   {},
                   ""};
  for (const auto& [name, s] : runs.sessions) {
    table.rows.push_back({name, Text(s.position_rmse_m, 2), Text(s.aligned_rmse_m, 2),
                          Text(s.final_error_m, 2), Text(s.dead_reckoning_final_error_m, 2),
                          Text(s.nees, 1), Text(s.realtime_factor, 0)});
  }
  return table;
}

bool IsCompared(const SessionStatistics& session) { return session.statuses_right.of > 0; }

/// The paper's two first, then the others by name.
std::vector<std::string> InOrder(const RunStatistics& runs) {
  std::vector<std::string> names;
  for (const auto& [name, session] : runs.sessions)
    names.push_back(name);
  SortSessions(names);
  return names;
}

}  // namespace

std::vector<PaperTable> PaperTables(const RunStatistics& runs) {
  std::vector<PaperTable> tables;
  const bool is_basin = runs.mission.starts_with("basin");
  const std::vector<std::string> names = InOrder(runs);
  for (const std::string& name : names) {
    const SessionStatistics& session = runs.sessions.at(name);
    tables.push_back(IsCompared(session) ? StatusTable(name, session) : PlaceTable(name, session));
  }
  for (const std::string& name : names) {
    const SessionStatistics& session = runs.sessions.at(name);
    const PaperPaths* paper = name == "discovery" ? (is_basin ? &kTable7 : &kTable4)
                              : name == "change"  ? (is_basin ? &kTable8 : &kTable5)
                                                  : &kNotInThePaper;
    const char* number = name == "discovery" ? (is_basin ? "Table 7: " : "Table 4: ")
                         : name == "change"  ? (is_basin ? "Table 8: " : "Table 5: ")
                                             : "Way: ";
    tables.push_back(
        PathTable(fmt::format("{}{} session", number, name), session, *paper, IsCompared(session)));
  }
  tables.push_back(NavigationTable(runs));
  tables.push_back(RateTable(runs));
  return tables;
}

}  // namespace limpet
