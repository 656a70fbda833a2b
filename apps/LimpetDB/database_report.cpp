// SPDX-License-Identifier: MIT
#include "apps/LimpetDB/database_report.hpp"

#include <utility>

#include <fmt/format.h>

#include "limpet/app/report_lines.hpp"
#include "limpet/core/clock.hpp"
#include "limpet/pubsub/broker_status.hpp"
#include "limpet/topics/wall_clock.hpp"

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
  WatchClock(words);
  if (std::exchange(has_news_of_warnings_, false)) {
    std::string text;
    for (const auto& [id, meaning] : warnings_) {
      text += (text.empty() ? "" : "; ") + id + ": " + meaning;
    }
    words.emplace_back("LIMPETDB_WARNINGS", text.empty() ? "none" : text);
  }
  if (now - last_status_ >= Seconds(kStatusPeriod * warp_)) {
    last_status_ = now;
    words.emplace_back(status_.variable(), status_.Text(looks_, now));
  }
  if (caster_.IsDue(now)) {
    words.emplace_back("APPCAST", EncodeAppCast(caster_.Cast(Body(broker, now), looks_, now)));
  }
  return words;
}

void DatabaseReport::Raise(const std::string& id, const std::string& text) {
  std::string& known = warnings_[id];
  if (known != text) {
    known = text;
    has_news_of_warnings_ = true;
    caster_.RaiseWarning(id, text);
  }
}

void DatabaseReport::WatchClock(TcpBrokerOptions::Words& words) {
  const auto news = clock_.Look(VehicleTime(), UnixTime());
  if (!news) {
    return;
  }
  words.emplace_back(topics::kWallClock.name, news->record);
  if (news->warning) {
    Raise("CLOCK_STEPPED", *news->warning);
  } else if (warnings_.erase("CLOCK_STEPPED") > 0) {
    has_news_of_warnings_ = true;
    caster_.ClearWarning("CLOCK_STEPPED");
  }
}

void DatabaseReport::Watch(const Broker& broker) {
  for (const ClientFacts& client : broker.Clients()) {
    if (client.dropped > 0) {
      Raise("SLOW_" + client.name,
                           fmt::format("{} reads too slowly and has lost mail", client.name));
    }
  }
  if (broker.counts().no_room > 0) {
    Raise("NO_ROOM", "writes were refused: stored_mib is used up");
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
