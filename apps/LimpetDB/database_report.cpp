// SPDX-License-Identifier: MIT
#include "apps/LimpetDB/database_report.hpp"

#include <utility>

#include <fmt/format.h>

#include "apps/LimpetDB/database_warnings.hpp"
#include "limpet/app/report_lines.hpp"
#include "limpet/core/clock.hpp"
#include "limpet/pubsub/broker_status.hpp"
#include "limpet/topics/wall_clock.hpp"

namespace limpet {
namespace {

constexpr const char* kName = "LimpetDB";
constexpr double kStatusPeriod = 2.0;  ///< real time [s]
constexpr double kSettled = 30.0;      ///< of a count that has stopped growing, real time [s]

std::string InKib(std::size_t bytes) {
  return fmt::format("{:.1f} KiB", static_cast<double>(bytes) / 1024.0);
}

}  // namespace

DatabaseReport::DatabaseReport(const std::string& community, double warp, std::string where,
                               Seconds now)
    : status_(kName, now),
      warnings_(warp),
      started_(now),
      where_(std::move(where)),
      warp_(warp),
      messages_at_(now) {
  caster_.Configure({.process = kName, .node = community, .warp = warp});
}

TcpBrokerOptions::Words DatabaseReport::Take(const Broker& broker, Seconds now, Seconds wall) {
  TcpBrokerOptions::Words words;
  ++looks_;
  Watch(broker, now);
  WatchClock(words, now, wall);
  if (std::optional<std::string> news = warnings_.TakeNews(now)) {
    words.emplace_back(WarningsVariable(kName), *std::move(news));
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

void DatabaseReport::Raise(const WarningId& id, const std::string& text, Seconds now) {
  if (warnings_.Raise(id, text, now) != WarningBoard::Change::kNone) {
    caster_.RaiseWarning(id, text, now - started_);
  }
}

void DatabaseReport::Clear(const WarningId& id) {
  if (warnings_.Clear(id)) {
    caster_.ClearWarning(id);
  }
}

void DatabaseReport::WatchClock(TcpBrokerOptions::Words& words, Seconds now, Seconds wall) {
  const auto news = clock_.Look(VehicleTime(), wall);
  if (!news) {
    return;
  }
  words.emplace_back(topics::kWallClock.name, news->record);
  if (news->warning) {
    Raise(warnings::kClockStepped, *news->warning, now);
  } else {
    Clear(warnings::kClockStepped);
  }
}

void DatabaseReport::WatchCount(const WarningId& id, std::uint64_t count, const std::string& text,
                                Seconds now) {
  Growth& growth = growths_.try_emplace(id.name(), Growth{.id = id}).first->second;
  if (count > growth.count) {
    growth.last = now;
    Raise(id, fmt::format("{} {}", count, text), now);
  }
  growth.count = count;  // less: a client of this name began anew
}

void DatabaseReport::ClearSettledCounts(Seconds now) {
  for (auto& [name, growth] : growths_) {
    if (growth.last && now - *growth.last > Seconds(kSettled * warp_)) {
      growth.last.reset();
      Clear(growth.id);
    }
  }
}

void DatabaseReport::Watch(const Broker& broker, Seconds now) {
  const BrokerCounts& counts = broker.counts();
  WatchCount(warnings::kStrangers, counts.strangers,
             "connections were closed that had not said who they are: too slow, or too many", now);
  WatchCount(warnings::kUnfinished, counts.unfinished,
             "clients were cut amid a packet: too slow, or held_mib is used up", now);
  WatchCount(warnings::kStalled, counts.stalled,
             "clients were cut that took no mail, or held_mib is used up", now);
  WatchCount(warnings::kNoRoom, counts.no_room, "writes were refused: stored_mib is used up", now);
  for (const ClientFacts& client : broker.Clients()) {
    if (client.dropped > 0) {
      WatchCount(warnings::kSlow.Of(client.name), client.dropped,
                 fmt::format("messages for {} are lost: it reads too slowly", client.name), now);
    }
  }
  ClearSettledCounts(now);
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
  const HeldMemory& memory = broker.memory();
  report.Pair(
      "Held for clients",
      fmt::format("{} of unfinished packets, {} of unsent mail; at most {}",
                  InKib(memory.unfinished()), InKib(memory.queued()), InKib(memory.limit())));
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
