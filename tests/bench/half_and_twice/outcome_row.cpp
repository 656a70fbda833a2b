// SPDX-License-Identifier: MIT
#include "tests/bench/half_and_twice/outcome_row.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace limpet {

void OutcomeRow::AddSession(const nlohmann::json& session) {
  ++sessions_;
  home_ += session.at("ended") == "home" ? 1 : 0;
  home_error_most_m_ = std::max(home_error_most_m_, session.at("home_error_m").get<double>());
  missed_ += static_cast<int>(session.at("missed").size());
  invented_ += static_cast<int>(session.at("false").size());
  nees_sum_ += session.at("nav").at("nees_mean").get<double>();
  for (const nlohmann::json& opi : session.at("opis")) {
    const double error = opi.at("error_m");
    ++objects_;
    error_sum_m_ += error;
    error_most_m_ = std::max(error_most_m_, error);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double off =
          opi.at("slam_ned_m")[axis].get<double>() - opi.at("truth_ned_m")[axis].get<double>();
      squared_ratio_sum_ += std::pow(off / opi.at("slam_sd_m")[axis].get<double>(), 2.0);
    }
  }
}

void OutcomeRow::Add(const nlohmann::json& report) {
  for (const auto& [name, session] : report.at("sessions").items()) {
    AddSession(session);
    if (!session.contains("changes")) continue;
    for (const nlohmann::json& change : session.at("changes")) {
      const bool is_right = change.at("decided") == change.at("expected");
      const bool is_open =
          change.at("decided") == "uncertain" || change.at("decided") == "not_inspected";
      ++(is_right ? right_ : is_open ? open_ : wrong_);
    }
  }
}

std::string OutcomeRow::Text() const {
  if (sessions_ == 0) return "| - |\n";
  const double objects = std::max(objects_, 1);
  return fmt::format(
      "| {}/{} | {:.1f} | {} | {} | {} | {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} |\n", home_,
      sessions_, home_error_most_m_, right_, open_, wrong_, invented_, missed_,
      error_sum_m_ / objects, error_most_m_, nees_sum_ / sessions_, squared_ratio_sum_ / objects);
}

std::string OutcomePageHead(std::uint64_t first, std::uint64_t last) {
  constexpr const char* kHead = R"(# Half and twice of what is believed

missions/table1, both sessions in closed loop with the boxes camera, seeds {0} to {1} as far as they were flown
(`home` counts sessions): each thing that the vehicle assumes, halved and doubled in the simulator alone. Last, the
DVL's dropouts in a current that nobody knows. Statuses are the change session's (five objects a run); invented and
missed objects are of both sessions. NEES of poses: 3 if the stated covariance is right, less if it is too cautious;
the same of the objects' places, axis by axis. A session's GPS error and heading are one sample for all of its poses
and objects. Generated: `half_and_twice fly build/bin/limpet missions/table1 FOLDER {0} {1}` (`tests/bench`).

| what is not as believed | home | farthest from it [m] | right | open | wrong | invented | missed | error of objects, mean [m] | worst [m] | NEES of poses | of objects |
|---|---|---|---|---|---|---|---|---|---|---|---|
)";
  return fmt::format(fmt::runtime(kHead), first, last);
}

}  // namespace limpet
