// SPDX-License-Identifier: MIT
#include "tests/soak/soak_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "tests/soak/pooled_slope.hpp"

namespace limpet {
namespace {

constexpr double kHour = 3600.0;

/// What all lives of one app show together.
struct AppAccount {
  int lives = 0, watched = 0, kills = 0, stops = 0;
  double most_mib = 0.0;
  int most_descriptors = 0, descriptor_growth = 0;
  PooledSlope memory;  ///< [MiB] per hour of vehicle time
  std::optional<double> longest_restart_s;
};

void AddLife(const SoakPlan& plan, const ProcessLife& life, AppAccount& account) {
  ++account.lives;
  account.most_mib = std::max(account.most_mib, *std::ranges::max_element(life.resident_mib));
  account.most_descriptors =
      std::max(account.most_descriptors, *std::ranges::max_element(life.descriptors));
  const double warm = plan.warm_up.value();
  if (life.times_s.back() < warm + plan.least_watch.value()) return;
  ++account.watched;
  const auto first = std::ranges::lower_bound(life.times_s, warm) - life.times_s.begin();
  std::vector<double> hours, memory;
  for (std::size_t i = static_cast<std::size_t>(first); i < life.times_s.size(); ++i) {
    hours.push_back(life.times_s[i] * plan.warp / kHour);
    memory.push_back(life.resident_mib[i]);
  }
  account.memory.Add(hours, memory);
  const int then = life.descriptors[static_cast<std::size_t>(first)];
  const int most = *std::max_element(life.descriptors.begin() + first, life.descriptors.end());
  account.descriptor_growth = std::max(account.descriptor_growth, most - then);
}

std::map<std::string, AppAccount> AccountsOf(const SoakPlan& plan,
                                             const std::vector<SoakRun>& runs) {
  std::map<std::string, AppAccount> accounts;
  for (const SoakRun& run : runs) {
    for (const auto& [pid, life] : run.lives) {
      AddLife(plan, life, accounts[life.name]);
    }
    for (const auto& [name, count] : run.kills) {
      accounts[name].kills += count;
    }
    for (const auto& [name, count] : run.stops) {
      accounts[name].stops += count;
    }
    for (const auto& [name, restarts] : run.restarts_s) {
      std::optional<double>& longest = accounts[name].longest_restart_s;
      longest = std::max(longest.value_or(0.0), *std::ranges::max_element(restarts));
    }
  }
  return accounts;
}

std::string TextOf(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

/// The value below which 95 % lie; infinite if there is none: nothing ever came back.
double MostOf95Percent(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::infinity();
  const auto at = static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

}  // namespace

std::string AppTable(const SoakPlan& plan, const std::vector<SoakRun>& runs) {
  std::string table =
      fmt::format("{:<14}{:>6}{:>8}{:>7}{:>7}{:>10}{:>12}{:>7}{:>8}{:>11}\n", "app", "lives",
                  "watched", "kills", "stops", "most MiB", "MiB/h", "files", "growth", "restart s");
  for (const auto& [name, app] : AccountsOf(plan, runs)) {
    table +=
        fmt::format("{:<14}{:>6}{:>8}{:>7}{:>7}{:>10.1f}{:>12}{:>7}{:>8}{:>11}\n", name, app.lives,
                    app.watched, app.kills, app.stops, app.most_mib, TextOf(app.memory.value(), 1),
                    app.most_descriptors, app.descriptor_growth, TextOf(app.longest_restart_s, 1));
  }
  return table;
}

std::vector<SoakVerdict> VerdictsOf(const SoakPlan& plan, const std::vector<SoakRun>& runs) {
  double slope = 0.0, memory = 0.0, growth = 0.0, restart = 0.0, watched = 0.0;
  for (const auto& [name, app] : AccountsOf(plan, runs)) {
    slope = std::max(slope, app.memory.value().value_or(0.0));
    memory = std::max(memory, app.most_mib);
    growth = std::max(growth, static_cast<double>(app.descriptor_growth));
    restart = std::max(restart, app.longest_restart_s.value_or(0.0));
    watched += app.watched;
  }
  std::vector<double> trips;
  for (const SoakRun& run : runs) {
    trips.insert(trips.end(), run.round_trips_ms.begin(), run.round_trips_ms.end());
  }
  const auto failed =
      std::ranges::count_if(runs, [](const SoakRun& run) { return !run.Complaint().empty(); });
  return {{"runs with a complaint", static_cast<double>(failed), 0.0},
          {"apps that were never watched for long", watched > 0.0 ? 0.0 : 1.0, 0.0},
          {"memory slope, MiB per vehicle hour", slope, plan.most_slope_mib_per_h},
          {"memory of a process, MiB", memory, plan.most_memory_mib},
          {"growth of open files", growth, static_cast<double>(plan.most_descriptor_growth)},
          {"round trip of mail, 95 %, ms", MostOf95Percent(trips), plan.most_round_trip_ms},
          {"restart of a killed process, s", restart, plan.most_restart.value()}};
}

}  // namespace limpet
