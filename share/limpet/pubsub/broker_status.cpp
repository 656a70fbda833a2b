// SPDX-License-Identifier: MIT
#include "limpet/pubsub/broker_status.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include <fmt/format.h>

namespace limpet {
namespace {

std::vector<std::string> PublicationsOf(const Router& router, const std::string& name) {
  std::vector<std::string> names;
  for (const Router::Variable variable : router.Sorted()) {
    const Router::VariableInfo& info = router.Info(variable);
    if (std::ranges::binary_search(info.writers, name)) {
      names.push_back(info.name);
    }
  }
  return names;
}

std::string ClockText(Seconds time) {
  const double whole = std::floor(time.value());
  const auto seconds = static_cast<std::time_t>(whole);
  std::tm local{};
  localtime_r(&seconds, &local);
  return fmt::format("{:02}:{:02}:{:02}.{:03}", local.tm_hour, local.tm_min, local.tm_sec,
                     static_cast<int>(1e3 * (time.value() - whole)));
}

std::string ValueText(const WireMessage& message) {
  constexpr std::size_t kLongest = 25;
  switch (message.data_type) {
    case wire_data::kDouble:
      return fmt::format("{:.1f}", message.number);
    case wire_data::kBinary:
      return fmt::format("*binary* {} bytes", message.text.size());
    default:
      return message.text.size() <= kLongest
                 ? std::string(message.text)
                 : std::string(message.text.substr(0, kLongest - 3)) + "...";
  }
}

}  // namespace

std::string ProcessSummary(const Router& router, Router::Client client) {
  const std::string& name = router.NameOf(client);
  std::string text = name + ":SUBSCRIBED=,";
  for (const std::string& variable : router.SubscriptionsOf(client)) {
    text += variable + ",";
  }
  text += "PUBLISHED=";
  for (const std::string& variable : PublicationsOf(router, name)) {
    text += "," + variable;
  }
  return text;
}

std::string ReadWriteSummary(const Router& router, Router::Client client) {
  const std::string& name = router.NameOf(client);
  return fmt::format("{}={}&{}", name, fmt::join(router.SubscriptionsOf(client), ":"),
                     fmt::join(PublicationsOf(router, name), ":"));
}

std::string VariableNames(const Router& router) {
  std::string text;
  for (const Router::Variable variable : router.Sorted()) {
    text += (text.empty() ? "" : ",") + router.Info(variable).name;
  }
  return text;
}

double WriteFrequency(const Router::VariableInfo& info, Seconds started) {
  const double span = (info.written - started).value();
  return info.writes == 0 || span <= 0.0 ? 0.0 : static_cast<double>(info.writes) / span;
}

std::string RefusalSummary(const BrokerCounts& counts) {
  return fmt::format(
      "type_mismatch={},foreign_source={},bad_name={},no_room={},stranger={},unfinished={},"
      "stalled={},silent={}",
      counts.type_mismatches, counts.foreign_sources, counts.bad_names, counts.no_room,
      counts.strangers, counts.unfinished, counts.stalled, counts.silent);
}

std::string VariableTable(const Broker& broker) {
  std::string table;
  for (const Router::Variable variable : broker.router().Sorted()) {
    const Router::VariableInfo& info = broker.router().Info(variable);
    const auto latest = broker.LatestOf(variable);
    if (!latest) {
      table += fmt::format("{:<20} {:<20} {:<20}\n", info.name, "", "(write pending)");
      continue;
    }
    table +=
        fmt::format("{:<20} {:<20} {:<16} {:>7.1f} Hz {}  {}\n", info.name, ClockText(info.written),
                    latest->source, WriteFrequency(info, broker.started()), latest->data_type,
                    ValueText(*latest));
  }
  return table;
}

}  // namespace limpet
