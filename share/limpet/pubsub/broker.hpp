// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/pubsub/held_memory.hpp"
#include "limpet/pubsub/outbox.hpp"
#include "limpet/pubsub/outgoing_packet.hpp"
#include "limpet/pubsub/router.hpp"
#include "limpet/wire/packet_codec.hpp"

namespace limpet {

struct BrokerLimits {
  std::size_t clients = 1000;
  std::size_t variables = 100'000;
  std::size_t name_length = 1024;               ///< of clients and variables [bytes]
  std::size_t filters_per_client = 1000;        ///< wildcards
  std::size_t queue = std::size_t{4} << 20;     ///< memory for unsent mail of one client [bytes]
  std::size_t stored = std::size_t{256} << 20;  ///< latest values of all variables [bytes]
  /// Unfinished packets and unsent mail of all clients together [bytes].
  std::size_t held = std::size_t{88} << 20;
};

struct BrokerOptions {
  std::string community = "limpet";
  std::string hostname;
  BrokerLimits limits;
  /// Told the text of each write of this variable; empty: none.
  std::string watched{};
  std::function<void(std::string_view text)> on_watched{};
};

/// A client as the database's report lists it.
struct ClientFacts {
  std::string name;
  bool is_async = true;
  std::optional<double> delay_ms;  ///< of its last timing message
  std::size_t waiting = 0;         ///< unsent mail [bytes]
  std::uint64_t dropped = 0;       ///< messages it was too slow for
};

/// What the broker refused or lost, since the start.
struct BrokerCounts {
  std::uint64_t messages = 0;  ///< writes taken
  std::uint64_t type_mismatches = 0;
  std::uint64_t foreign_sources = 0;  ///< registrations under another client's name
  std::uint64_t bad_names = 0;        ///< of variables: empty, too long, or one too many
  std::uint64_t no_room = 0;          ///< writes that would not fit beside what is stored
  std::uint64_t strangers = 0;        ///< connections cut that had not said who they are
  std::uint64_t unfinished = 0;       ///< clients cut amid a packet: too slow, or memory was short
  std::uint64_t stalled = 0;          ///< clients cut that took no mail, or memory was short
  std::uint64_t silent = 0;           ///< clients cut that said nothing for too long
};

/// The MOOS V10 broker without its sockets: packets in, packets out, time handed in. What it knows
/// of the protocol is in docs/wire.md. Not thread-safe.
class Broker {
 public:
  using Client = Router::Client;

  Broker(BrokerOptions options, Seconds now);
  ~Broker();
  Broker(const Broker&) = delete;
  Broker& operator=(const Broker&) = delete;

  /// Takes a hello. Either a client, or why it was refused; `answer` is the packet to send.
  struct Admission {
    std::optional<Client> client;
    ByteBuffer answer;
  };
  [[nodiscard]] Admission Admit(const WireMessage& hello, Seconds now);
  /// The client is gone: its name is free, its mail forgotten.
  void Leave(Client client, Seconds now);

  /// Works off one whole packet; what is wrong with it ends the connection.
  [[nodiscard]] std::optional<Error> Receive(Client client, ByteView packet, Seconds now);
  /// Writes the DB_* variables; every 2 s of MOOS time.
  void PublishStatus(Seconds now);
  /// Writes a variable in the broker's own name.
  void Publish(std::string_view name, std::string_view value, Seconds now);

  /// Clients that have something to send since the last call, each once.
  [[nodiscard]] std::vector<Client> TakeReady();
  /// The client's next packet. False: there is nothing to send.
  [[nodiscard]] bool TakePacket(Client client, OutgoingPacket& packet, Seconds now);
  [[nodiscard]] Outbox& outbox(Client client);

  [[nodiscard]] const Router& router() const { return router_; }
  /// Nothing if it has never been written. The views die with the next write of that variable.
  [[nodiscard]] std::optional<WireMessage> LatestOf(Router::Variable variable) const;
  /// When it started, or was last cleared.
  [[nodiscard]] Seconds started() const { return started_; }
  [[nodiscard]] const BrokerCounts& counts() const { return counts_; }
  /// Counts that the owner of the connections may raise, who counts what it cuts.
  [[nodiscard]] BrokerCounts& counts() { return counts_; }
  [[nodiscard]] HeldMemory& memory() { return memory_; }
  [[nodiscard]] const HeldMemory& memory() const { return memory_; }
  /// Counts unsent mail; where it is too much, the longest queues lose their oldest. What is left
  /// above the budget is with connections already.
  void BoundMail();
  [[nodiscard]] std::uint64_t clears() const { return clears_; }
  /// What is known of the clients, sorted by name.
  [[nodiscard]] std::vector<ClientFacts> Clients() const;
  /// Bytes of all latest values.
  [[nodiscard]] std::size_t stored() const { return stored_; }
  [[nodiscard]] const BrokerOptions& options() const { return options_; }

  // For a keeper of values (value_keeper.hpp).

  /// Takes encoded messages, back to back, as writes; ends at the first that is none.
  void Restore(ByteView messages, Seconds now);
  /// From now on each variable that is written is listed in news(), once until TakeNewsOf.
  void ListNews() { lists_news_ = true; }
  [[nodiscard]] std::vector<Router::Variable>& news() { return news_; }
  /// What is stored of it, as forwarded, unless it is the broker's own or was never written: then
  /// nothing. The view dies with the next write of that variable.
  [[nodiscard]] ByteView StoredOf(Router::Variable variable) const;
  [[nodiscard]] ByteView TakeNewsOf(Router::Variable variable);

 private:
  struct Session;
  struct Latest {
    std::shared_ptr<ByteBuffer> message;  ///< as forwarded, community filled in
    bool is_news = false;                 ///< in news_, or taken from there and not yet asked for
    [[nodiscard]] std::size_t size() const { return message ? message->size() : 0; }
    /// Where to write the next one: connections may still be sending the last.
    [[nodiscard]] ByteBuffer& Renew(const std::shared_ptr<std::size_t>& alive);
  };

  void Work(Session& session, const WireMessage& message, ByteView raw, Seconds now);
  void Notify(const WireMessage& message, ByteView raw, Seconds now);
  /// Keeps `raw` as the variable's latest; false if there is no room for it.
  [[nodiscard]] bool Store(Latest& latest, const WireMessage& message, ByteView raw);
  void Register(Session& session, const WireMessage& message, Seconds now);
  void RegisterWildcard(Session& session, const WireMessage& message, Seconds now);
  void Answer(Session& session, const WireMessage& request, Seconds now);
  void AnswerAll(Session& session);
  void Append(Session& session, Router::Variable variable, const WireMessage& message);
  void Clear(Seconds now);
  void SendLatest(Session& session, Router::Variable variable);
  /// The variable of that name, unless the name or one more variable is not allowed.
  [[nodiscard]] std::optional<Router::Variable> Variable(std::string_view name);
  [[nodiscard]] bool SpeaksForItself(const Session& session, const WireMessage& message);
  void Publish(std::string_view name, double value, Seconds now);
  void PublishOwn(WireMessage message, std::string_view name, Seconds now);
  void MarkReady(Session& session);
  [[nodiscard]] std::size_t CountMail() const;

  BrokerOptions options_;
  std::string source_;  ///< of the broker's own variables
  Seconds started_;
  Router router_;
  std::vector<std::unique_ptr<Session>> sessions_;  ///< by client
  std::vector<Latest> latest_;                      ///< by variable
  std::size_t stored_ = 0;                          ///< bytes in latest_
  /// Bytes of all messages that were stored and live on: those that are not the latest any more are
  /// in queues.
  std::shared_ptr<std::size_t> alive_ = std::make_shared<std::size_t>(0);
  HeldMemory memory_;
  std::size_t queued_since_ = 0;  ///< bytes, since mail was last counted
  std::vector<Client> ready_;
  ByteBuffer scratch_;
  BrokerCounts counts_;
  std::uint64_t clears_ = 0;
  bool lists_news_ = false;
  std::vector<Router::Variable> news_;
};

}  // namespace limpet
