// SPDX-License-Identifier: MIT
// What the broker says of itself: answers to requests, and the DB_* variables.
#include <fmt/format.h>

#include "limpet/pubsub/broker.hpp"
#include "limpet/pubsub/broker_session.hpp"
#include "limpet/pubsub/broker_status.hpp"
#include "limpet/wire/message_id.hpp"

namespace limpet {

void Broker::Answer(Session& session, const WireMessage& request, Seconds now) {
  const auto asks_for = [&request](std::string_view what) {
    return request.key.find(what) != std::string_view::npos;
  };
  const auto answer = [&](std::string_view key, Seconds time, const std::string& text) {
    Append(session, Outbox::kNoVariable,
           {.id = message_id::kAnswer,
            .data_type = wire_data::kString,
            .source = source_,
            .key = key,
            .time = time.value(),
            .text = text});
  };
  if (request.key == "ALL") {
    AnswerAll(session);
  } else if (asks_for("PROC_SUMMARY")) {
    for (const auto& other : sessions_) {
      if (other) {
        answer("PROC_SUMMARY", now - started_, ProcessSummary(router_, other->client));
      }
    }
  } else if (asks_for("VAR_SUMMARY")) {
    answer("VAR_SUMMARY", now, VariableNames(router_));
  } else if (asks_for("DB_CLEAR")) {
    Clear(now);
  }
}

void Broker::AnswerAll(Session& session) {
  std::vector<Router::Variable> variables = router_.Sorted();
  std::ranges::reverse(variables);  // MOOS's order: last name first
  for (const Router::Variable variable : variables) {
    const Router::VariableInfo& info = router_.Info(variable);
    WireMessage answer{.data_type = wire_data::kUnset};
    if (const auto latest = LatestOf(variable)) {
      answer = *latest;
      answer.time = (info.written - started_).value();
    }
    answer.number2 = WriteFrequency(info, started_);
    answer.id = message_id::kAnswer;
    answer.key = info.name;
    Append(session, Outbox::kNoVariable, answer);
  }
}

std::vector<ClientFacts> Broker::Clients() const {
  std::vector<ClientFacts> clients;
  for (const auto& session : sessions_) {
    if (session) {
      const LinkQuality& quality = session->quality;
      clients.push_back(
          {.name = session->name,
           .is_async = session->is_async,
           .delay_ms = quality.count > 0 ? std::optional(quality.recent_ms) : std::nullopt,
           .waiting = session->outbox.size() + session->outbox.in_flight(),
           .dropped = session->outbox.dropped()});
    }
  }
  std::ranges::sort(clients, {}, &ClientFacts::name);
  return clients;
}

void Broker::PublishStatus(Seconds now) {
  std::vector<const Session*> present;
  for (const auto& session : sessions_) {
    if (session) {
      present.push_back(session.get());
    }
  }
  std::string names, quality, traffic, losses;
  std::ranges::reverse(present);  // MOOS's order: who came last first
  for (const Session* session : present) {
    names += session->name + ",";
  }
  std::ranges::sort(present, {}, &Session::name);
  for (const Session* session : present) {
    const LinkQuality& q = session->quality;
    quality += fmt::format("{}={:g}:{:g}:{:g}:{:g},", session->name, q.recent_ms, q.max_ms,
                           q.min_ms, q.mean_ms);
    traffic += ReadWriteSummary(router_, session->client) + ",";
    if (session->outbox.dropped() > 0) {
      losses += fmt::format("{}={},", session->name, session->outbox.dropped());
    }
  }
  if (!traffic.empty()) {
    traffic.pop_back();
  }
  Publish("DB_TIME", now.value(), now);
  Publish("DB_UPTIME", (now - started_).value(), now);
  Publish("DB_CLIENTS", names, now);
  Publish("DB_VARSUMMARY", VariableTable(*this), now);
  Publish("DB_QOS", quality, now);
  Publish("DB_RWSUMMARY", traffic, now);
  Publish("DB_DROPPED", losses, now);
  Publish("DB_REFUSED", RefusalSummary(counts_), now);
}

}  // namespace limpet
