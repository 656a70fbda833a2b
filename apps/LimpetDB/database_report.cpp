// SPDX-License-Identifier: MIT
#include "apps/LimpetDB/database_report.hpp"

#include <fmt/format.h>

#include "limpet/app/report_lines.hpp"
#include "limpet/pubsub/broker_status.hpp"

namespace limpet {
namespace {

constexpr const char* kName = "LimpetDB";
constexpr double kStatusPeriod = 2.0;  ///< real time [s]

std::string InKib(std::size_t bytes) {
  return fmt::format("{:.1f} KiB", static_cast<double>(bytes) / 1024.0);
}

}  // namespace

DatabaseReport::DatabaseReport(const std::string& community, double warp, std::string where,
                               Seconds now)
    : status_(kName, now), where_(std::move(where)), warp_(warp), messages_at_(now) {
  caster_.Configure({.process = kName, .node = community, .warp = warp});
}

TcpBrokerOptions::Words DatabaseReport::Take(const Broker& broker, Seconds now) {
  TcpBrokerOptions::Words words;
  ++looks_;
  Watch(broker);
  if (now - last_status_ >= Seconds(kStatusPeriod * warp_)) {
    last_status_ = now;
    words.emplace_back(status_.variable(), status_.Text(looks_, now));
  }
  if (caster_.IsDue(now)) {
    words.emplace_back("APPCAST", EncodeAppCast(caster_.Cast(Body(broker, now), looks_, now)));
  }
  return words;
}

void DatabaseReport::Watch(const Broker& broker) {
  for (const ClientFacts& client : broker.Clients()) {
    if (client.dropped > 0) {
      caster_.RaiseWarning("SLOW_" + client.name,
                           fmt::format("{} reads too slowly and has lost mail", client.name));
    }
  }
  if (broker.counts().no_room > 0) {
    caster_.RaiseWarning("NO_ROOM", "writes were refused: stored_mib is used up");
  }
}

std::vector<std::string> DatabaseReport::Body(const Broker& broker, Seconds now) {
  const BrokerCounts& counts = broker.counts();
  const double span = (now - messages_at_).value() / warp_;
  const double rate = span > 0.0 ? static_cast<double>(counts.messages - messages_) / span : 0.0;
  messages_ = counts.messages;
  messages_at_ = now;
  ReportLines report;
  report.Pair("Listens on", fmt::format("{}, time warp {:g}", where_, warp_));
  report.Pair("Up for", fmt::format("{:.0f} s", (now - broker.started()).value()));
  report.Pair("Writes", fmt::format("{}, {:.0f} per real second lately", counts.messages, rate));
  report.Pair("Variables", fmt::format("{}, {} stored", broker.router().variable_count(),
                                       InKib(broker.stored())));
  report.Pair("Refused", RefusalSummary(counts));
  report.Blank();
  ReportTable table({"client", "kind", ">delay ms", ">waiting", ">lost"});
  for (const ClientFacts& client : broker.Clients()) {
    table.AddRow({client.name, client.is_async ? "async" : "sync",
                  client.delay_ms ? fmt::format("{:.2f}", *client.delay_ms) : "-",
                  InKib(client.waiting), std::to_string(client.dropped)});
  }
  report.Add(table);
  return report.lines();
}

}  // namespace limpet
