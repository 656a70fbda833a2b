// SPDX-License-Identifier: MIT
#include "limpet/report/expectation_check.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limpet/objects/status_posterior.hpp"

namespace limpet {
namespace {

using Json = nlohmann::json;
using Number = std::optional<double>;

Number NumberOf(const Json& value) {
  return value.is_number() ? Number(value.get<double>()) : std::nullopt;
}

/// `<coverage|detectable>_<percent>_path_m`.
Number PathOfLevel(const Json& session, const std::string& key) {
  const std::size_t bar = key.find('_');
  const double level = std::stod(key.substr(bar + 1, 2)) / 100.0;
  for (const Json& entry : session.at(key.substr(0, bar))) {
    if (std::abs(entry.at("level").get<double>() - level) < 1e-9) {
      return NumberOf(entry.at("path_m"));
    }
  }
  return std::nullopt;
}

/// Nothing where nobody knows the truth.
Number CountOf(const Json& list) {
  return list.is_array() ? Number(static_cast<double>(list.size())) : std::nullopt;
}

/// Largest of all found objects; 0 if none was found, which `missed` tells; nothing without truth.
Number LargestOfObjects(const Json& session, const std::string& key) {
  if (!session.at("missed").is_array()) return std::nullopt;
  double largest = 0.0;
  for (const Json& opi : session.at("opis")) {
    largest = std::max(largest, opi.at(key).get<double>());
  }
  return largest;
}

Number WrongStatuses(const Json& session) {
  if (!session.contains("changes")) return std::nullopt;
  const Json& changes = session.at("changes");
  return static_cast<double>(std::count_if(changes.begin(), changes.end(), [](const Json& change) {
    return change.at("truth").is_null() || change.at("decided") != change.at("expected");
  }));
}

bool IsOpenIn(const Json& change) {
  const std::optional<Status> decided = StatusFromName(change.at("decided").get<std::string>());
  return decided && IsOpen(*decided);
}

/// What is left open is never wrong.
Number WrongWhenSure(const Json& session) {
  constexpr double kSure = 0.95;
  const bool has_changes = session.contains("changes");
  const Json& said = session.at(has_changes ? "changes" : "false");
  if (!said.is_array()) return std::nullopt;
  return static_cast<double>(std::count_if(said.begin(), said.end(), [&](const Json& entry) {
    const bool is_wrong =
        !has_changes || (!IsOpenIn(entry) && (entry.at("truth").is_null() ||
                                              entry.at("decided") != entry.at("expected")));
    return is_wrong && entry.at("probability").get<double>() >= kSure;
  }));
}

Number ValueOf(const Json& session, const std::string& key) {
  if (key.starts_with("coverage_") || key.starts_with("detectable_")) {
    return PathOfLevel(session, key);
  }
  if (key == "missed") return CountOf(session.at("missed"));
  if (key == "invented") return CountOf(session.at("false"));
  if (key == "wrong_statuses") return WrongStatuses(session);
  if (key == "wrong_when_sure") return WrongWhenSure(session);
  if (key == "error_m" || key == "aligned_error_m") return LargestOfObjects(session, key);
  if (session.contains(key)) return NumberOf(session.at(key));
  return session.at("nav").contains(key) ? NumberOf(session.at("nav").at(key)) : std::nullopt;
}

std::string TextOf(const ExpectedBound& bound) {
  if (bound.min && bound.max) return fmt::format("{} to {}", *bound.min, *bound.max);
  return bound.min ? fmt::format("at least {}", *bound.min)
                   : fmt::format("at most {}", bound.max.value_or(0.0));
}

void Compare(const SessionExpectation& expected, const std::string& name, const Json& session,
             ExpectationCheck& check) {
  if (expected.ended) {
    ++check.compared;
    const std::string ended = session.at("ended");
    if (ended != *expected.ended) {
      check.breaches.push_back(
          fmt::format("{}: ended {}, expected {}", name, ended, *expected.ended));
    }
  }
  for (const ExpectedBound& bound : expected.bounds) {
    ++check.compared;
    const Number value = ValueOf(session, bound.key);
    if (!value || (bound.min && *value < *bound.min) || (bound.max && *value > *bound.max)) {
      check.breaches.push_back(
          fmt::format("{}: {} is {}, expected {} ({}:{})", name, bound.key,
                      value ? fmt::format("{:.6g}", *value) : "unknown or never reached",
                      TextOf(bound), bound.where.file, bound.where.line));
    }
  }
}

}  // namespace

ExpectationCheck CheckReport(const Expectations& expected, const std::string& report_json) {
  ExpectationCheck check;
  try {
    const Json report = Json::parse(report_json);
    const Json& settings = report.at("settings");
    check.is_other_method =
        settings.at("planner") != expected.planner || settings.at("gain") != "full";
    if (check.is_other_method) return check;
    for (const auto& [name, session] : report.at("sessions").items()) {
      for (const SessionExpectation& expectation : expected.sessions) {
        if (expectation.session == "each" || expectation.session == name) {
          Compare(expectation, name, session, check);
        }
      }
    }
  } catch (const Json::exception& error) {
    throw std::runtime_error(fmt::format("not a report: {}", error.what()));
  }
  return check;
}

}  // namespace limpet
