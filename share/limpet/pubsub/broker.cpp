// SPDX-License-Identifier: MIT
#include "limpet/pubsub/broker.hpp"

#include <cmath>

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/require.hpp"
#include "limpet/pubsub/broker_session.hpp"
#include "limpet/pubsub/wildcard_text.hpp"
#include "limpet/wire/little_endian.hpp"
#include "limpet/wire/message_id.hpp"

namespace limpet {
namespace {

constexpr std::size_t kCountsOfMail = 16;  ///< while as much as the budget is queued

bool IsValueType(char type) {
  return type == wire_data::kDouble || type == wire_data::kString || type == wire_data::kBinary;
}

/// A client's name ends up in comma-separated lists that other programs split.
std::string WhyBadClientName(std::string_view name, const BrokerLimits& limits) {
  if (name.empty()) {
    return "a client needs a name";
  }
  if (name.size() > limits.name_length) {
    return fmt::format("a name of {} bytes; at most {}", name.size(), limits.name_length);
  }
  const bool is_clean = std::ranges::none_of(
      name, [](char c) { return c == ',' || static_cast<unsigned char>(c) < 0x20; });
  return is_clean ? "" : "a name must hold no comma and no control character";
}

/// Writes `raw` with `community` in place of the empty one that `message` (its view) has.
void FillCommunity(const WireMessage& message, ByteView raw, std::string_view community,
                   ByteBuffer& out) {
  const auto* at = reinterpret_cast<const std::byte*>(message.community.data());
  const auto before = static_cast<std::size_t>(at - raw.data()) - sizeof(std::int32_t);
  const auto* text = reinterpret_cast<const std::byte*>(community.data());
  out.clear();
  out.reserve(raw.size() + community.size());
  out.insert(out.end(), raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(before));
  out.resize(before + sizeof(std::int32_t));
  Put(out.data() + before, static_cast<std::int32_t>(community.size()));
  out.insert(out.end(), text, text + community.size());
  out.insert(out.end(), at, raw.data() + raw.size());
  Put(out.data(), static_cast<std::int32_t>(out.size()));
}

}  // namespace

Broker::Broker(BrokerOptions options, Seconds now)
    : options_(std::move(options)),
      source_("MOOSDB_" + options_.community),
      started_(now),
      memory_(options_.limits.held) {}
Broker::~Broker() = default;

Broker::Admission Broker::Admit(const WireMessage& hello, Seconds now) {
  const std::string name(hello.text);
  std::string refusal = WhyBadClientName(hello.text, options_.limits);
  if (refusal.empty() && router_.Clients().size() >= options_.limits.clients) {
    refusal = fmt::format("no room: {} clients are connected", options_.limits.clients);
  }
  const std::optional<Client> client =
      refusal.empty() ? router_.Connect(name) : std::optional<Client>();
  if (!client) {
    refusal = refusal.empty() ? fmt::format("the name {} is in use", name) : refusal;
    return {.client = {},
            .answer = PacketOf(
                {.type = wire_type::kPoison, .data_type = wire_data::kString, .text = refusal})};
  }
  auto session = std::make_unique<Session>(options_.limits.queue);
  session->client = *client;
  session->name = name;
  session->is_async = EqualsIgnoringCase(hello.key, "asynchronous");
  sessions_.resize(std::max<std::size_t>(sessions_.size(), *client + 1));
  sessions_[*client] = std::move(session);
  Publish("DB_EVENT", "connected=" + name, now);
  const std::string host = "hostname=" + options_.hostname;
  return {.client = client,
          .answer = PacketOf({.type = wire_type::kWelcome,
                              .data_type = wire_data::kDouble,
                              .source_aux = host,
                              .community = options_.community,
                              .time = now.value(),
                              .number = now.value() - hello.time,
                              .text = "asynchronous"})};
}

void Broker::Leave(Client client, Seconds now) {
  LIMPET_REQUIRE(client < sessions_.size() && sessions_[client], "unknown client");
  const std::string name = sessions_[client]->name;
  router_.Disconnect(client);
  std::erase(ready_, client);
  sessions_[client].reset();
  Publish("DB_EVENT", "disconnected=" + name, now);
}

std::optional<Error> Broker::Receive(Client client, ByteView packet, Seconds now) {
  Session& session = *sessions_[client];
  PacketReader reader(packet);
  for (bool is_first = true; !reader.is_at_end(); is_first = false) {
    const Expected<WireMessage> message = reader.Next();
    if (!message) {
      return message.error();
    }
    if (is_first && session.is_async && message->type == wire_type::kTiming) {
      session.quality.Add(1e3 * (now.value() - message->time));
      WireMessage echo = *message;
      echo.number = now.value();
      echo.number2 = 0.0;
      session.timing_echo.clear();
      AppendMessage(echo, session.timing_echo);
      MarkReady(session);
    } else {
      Work(session, *message, reader.raw(), now);
    }
  }
  if (!session.is_async) {
    session.owes_reply = true;
    MarkReady(session);
  }
  return std::nullopt;
}

void Broker::Work(Session& session, const WireMessage& message, ByteView raw, Seconds now) {
  switch (message.type) {
    case wire_type::kNotify:
      Notify(message, raw, now);
      break;
    case wire_type::kRegister:
      Register(session, message, now);
      break;
    case wire_type::kUnregister:
      if (const auto variable = router_.Find(message.key);
          variable && SpeaksForItself(session, message)) {
        router_.Unsubscribe(session.client, *variable);
      }
      break;
    case wire_type::kWildcardRegister:
    case wire_type::kWildcardUnregister:
      RegisterWildcard(session, message, now);
      break;
    case wire_type::kRequest:
      Answer(session, message, now);
      break;
    default:  // letters of other versions, and null messages, mean nothing here
      break;
  }
}

std::optional<Router::Variable> Broker::Variable(std::string_view name) {
  if (const auto known = router_.Find(name)) {
    return known;
  }
  if (name.empty() || name.size() > options_.limits.name_length ||
      router_.variable_count() >= options_.limits.variables) {
    ++counts_.bad_names;
    return std::nullopt;
  }
  const Router::Variable variable = router_.Intern(name);
  latest_.resize(router_.variable_count());
  return variable;
}

void Broker::Notify(const WireMessage& message, ByteView raw, Seconds now) {
  const std::optional<Router::Variable> variable = Variable(message.key);
  if (!variable || !IsValueType(message.data_type)) {
    return;
  }
  const auto type = router_.Info(*variable).type;
  if (type != Router::kUnset && type != message.data_type) {
    ++counts_.type_mismatches;
    return;
  }
  Latest& latest = latest_[*variable];
  if (!Store(latest, message, raw)) {
    ++counts_.no_room;
    return;
  }
  ++counts_.messages;
  if (message.key == options_.watched && options_.on_watched) {
    options_.on_watched(message.text);
  }
  if (lists_news_ && !latest.is_news) {
    latest.is_news = true;
    news_.push_back(*variable);
  }
  static_cast<void>(
      router_.Write(*variable, message.data_type, message.source, now, [&](Client client) {
        Session& session = *sessions_[client];
        session.outbox.Append(*variable, latest.message);
        queued_since_ += latest.message->size();
        MarkReady(session);
      }));
  if (queued_since_ > memory_.limit() / kCountsOfMail) {
    BoundMail();
  }
}

ByteBuffer& Broker::Latest::Renew(const std::shared_ptr<std::size_t>& alive) {
  if (!message || message.use_count() > 1) {
    message = std::shared_ptr<ByteBuffer>(new ByteBuffer, [alive](ByteBuffer* last) {
      *alive -= last->size();
      delete last;
    });
  }
  return *message;
}

bool Broker::Store(Latest& latest, const WireMessage& message, ByteView raw) {
  const std::size_t others = stored_ - latest.size();
  if (others + raw.size() + options_.community.size() > options_.limits.stored) {
    return false;
  }
  ByteBuffer& stored = latest.Renew(alive_);
  *alive_ -= stored.size();
  if (message.community.empty()) {
    FillCommunity(message, raw, options_.community, stored);
  } else {
    stored.assign(raw.begin(), raw.end());
  }
  *alive_ += stored.size();
  stored_ = others + stored.size();
  return true;
}

bool Broker::SpeaksForItself(const Session& session, const WireMessage& message) {
  const bool is_own = message.source == session.name;
  counts_.foreign_sources += is_own ? 0 : 1;
  return is_own;
}

void Broker::Register(Session& session, const WireMessage& message, Seconds now) {
  if (!SpeaksForItself(session, message)) {
    return;
  }
  const std::optional<Router::Variable> variable = Variable(message.key);
  if (variable && router_.Subscribe(session.client, *variable, Seconds(message.number), now)) {
    SendLatest(session, *variable);
  }
}

void Broker::RegisterWildcard(Session& session, const WireMessage& message, Seconds now) {
  const std::optional<WildcardFilter> filter = ParseWildcard(message.text);
  if (!filter || !SpeaksForItself(session, message)) {
    return;
  }
  if (message.type == wire_type::kWildcardUnregister) {
    router_.UnsubscribeWildcard(session.client, *filter);
    return;
  }
  if (router_.FilterCount(session.client) >= options_.limits.filters_per_client) {
    ++counts_.bad_names;
    return;
  }
  for (const Router::Variable variable : router_.SubscribeWildcard(session.client, *filter, now)) {
    SendLatest(session, variable);
  }
}

std::optional<WireMessage> Broker::LatestOf(Router::Variable variable) const {
  return router_.Info(variable).type == Router::kUnset
             ? std::nullopt
             : std::optional(DecodeMessage(*latest_[variable].message)->message);
}

ByteView Broker::StoredOf(Router::Variable variable) const {
  const auto& message = latest_[variable].message;
  const bool is_own = router_.Info(variable).last_writer == source_;
  return message && !is_own ? ByteView(*message) : ByteView();
}

ByteView Broker::TakeNewsOf(Router::Variable variable) {
  latest_[variable].is_news = false;
  return StoredOf(variable);
}

void Broker::Restore(ByteView messages, Seconds now) {
  while (!messages.empty()) {
    const Expected<DecodedMessage> decoded = DecodeMessage(messages);
    if (!decoded) {
      return;
    }
    Notify(decoded->message, messages.first(decoded->size), now);
    messages = messages.subspan(decoded->size);
  }
}

void Broker::Append(Session& session, Router::Variable variable, const WireMessage& message) {
  scratch_.clear();
  AppendMessage(message, scratch_);
  session.outbox.Append(variable, scratch_);
  MarkReady(session);
}

void Broker::SendLatest(Session& session, Router::Variable variable) {
  WireMessage latched = *LatestOf(variable);
  latched.id = message_id::kLatest;
  latched.number2 = -1.0;
  // Only the payload that the type names, whatever else the publisher sent along.
  if (latched.data_type == wire_data::kDouble) {
    latched.text = {};
  } else {
    latched.number = -1.0;
  }
  Append(session, variable, latched);
}

void Broker::Clear(Seconds now) {
  router_.Clear();
  for (Latest& latest : latest_) {
    latest.message = {};
  }
  stored_ = 0;
  ++clears_;
  for (const auto& session : sessions_) {
    if (session) {
      session->outbox.Clear();
    }
  }
  started_ = now;
}

void Broker::PublishOwn(WireMessage message, std::string_view name, Seconds now) {
  message.source = source_;
  message.community = options_.community;
  message.key = name;
  message.time = now.value();
  scratch_.clear();
  AppendMessage(message, scratch_);
  Notify(message, scratch_, now);
}

void Broker::Publish(std::string_view name, double value, Seconds now) {
  PublishOwn({.number = value}, name, now);
}

void Broker::Publish(std::string_view name, std::string_view value, Seconds now) {
  PublishOwn({.data_type = wire_data::kString, .text = value}, name, now);
}

void Broker::MarkReady(Session& session) {
  if (!session.is_ready) {
    session.is_ready = true;
    ready_.push_back(session.client);
  }
}

std::vector<Broker::Client> Broker::TakeReady() {
  std::vector<Client> ready;
  ready.swap(ready_);
  for (const Client client : ready) {
    sessions_[client]->is_ready = false;
  }
  return ready;
}

Outbox& Broker::outbox(Client client) { return sessions_[client]->outbox; }

bool Broker::TakePacket(Client client, OutgoingPacket& packet, Seconds now) {
  Session& session = *sessions_[client];
  packet.Begin();
  std::size_t count = 0;
  if (!session.is_async) {
    if (!session.owes_reply) {
      packet.Clear();
      return false;
    }
    session.owes_reply = false;
    AppendMessage({.type = wire_type::kNull, .number = now.value()}, packet.lead);
    count = 1;
  } else if (!session.timing_echo.empty()) {
    packet.lead.insert(packet.lead.end(), session.timing_echo.begin(), session.timing_echo.end());
    session.timing_echo.clear();
    count = 1;
  }
  count += session.outbox.Take(packet.mail);
  if (count == 0) {
    packet.Clear();
    return false;
  }
  packet.Seal(count);
  return true;
}

}  // namespace limpet
