// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "limpet/core/message.hpp"

namespace limpet {

/// Minimum time between deliveries, and which variables; `*` any run, `?` one character,
/// case-sensitive.
struct WildcardFilter {
  std::string app_pattern = "*";
  std::string variable_pattern = "*";
  Seconds interval;
};

/// True if the whole `text` matches `pattern`.
[[nodiscard]] bool MatchesWildcard(std::string_view pattern, std::string_view text);

/// The publish-subscribe database, free of any transport: who hears what, latest values, type lock.
/// Semantics are MOOS's (a wildcard is shorthand for subscribing to each variable that matches).
/// Not thread-safe: one thread owns it.
class Database {
 public:
  using Client = std::size_t;
  enum class WriteResult { kStored, kTypeMismatch };

  explicit Database(std::string community);

  /// Nothing if the name is empty or in use.
  [[nodiscard]] std::optional<Client> Connect(const std::string& name);
  /// Forgets subscriptions, filters and mail; variables stay.
  void Disconnect(Client client);

  /// Subscribes, and queues the current value at once if there is one, also when repeated.
  /// `interval` 0 or below delivers every write; otherwise writes that come too soon are dropped
  /// for this client.
  void Subscribe(Client client, const std::string& variable, Seconds interval, Seconds now);
  void Unsubscribe(Client client, std::string_view variable);
  /// Subscribes to all that matches now (judged by the last writer) and to what is first written
  /// later.
  void SubscribeWildcard(Client client, const WildcardFilter& filter, Seconds now);
  /// Drops the matching subscriptions and the filter itself.
  void UnsubscribeWildcard(Client client, const WildcardFilter& filter);

  /// Stores and queues for every subscriber. The first write fixes the data type; another type is
  /// refused.
  WriteResult Write(Message message, Seconds now);

  /// Takes all mail of a client, oldest first.
  [[nodiscard]] std::vector<MessagePtr> TakeMail(Client client);
  [[nodiscard]] bool HasMail(Client client) const { return !clients_[client].mail.empty(); }

  [[nodiscard]] MessagePtr Latest(std::string_view variable) const;
  /// Names of all variables, sorted.
  [[nodiscard]] std::vector<std::string> Variables() const;
  /// Names of connected clients, in order of connection.
  [[nodiscard]] std::vector<std::string> Clients() const;
  [[nodiscard]] const std::string& community() const { return community_; }

 private:
  struct Subscriber {
    Client client = 0;
    Seconds interval;
    std::optional<Seconds> last_delivery;
  };
  struct Variable {
    MessagePtr latest;
    std::vector<Subscriber> subscribers;  ///< in order of client name, as MOOS delivers
  };
  struct ClientState {
    std::string name;
    bool is_connected = false;
    std::vector<WildcardFilter> filters;
    std::vector<MessagePtr> mail;
  };
  struct NameHash {
    using is_transparent = void;
    std::size_t operator()(std::string_view name) const {
      return std::hash<std::string_view>{}(name);
    }
  };
  using VariableTable = std::unordered_map<std::string, Variable, NameHash, std::equal_to<>>;

  Variable& CreateVariable(const std::string& name);
  void AddSubscriber(Variable& variable, Client client, Seconds interval);
  void SubscribeMatchingClients(Variable& variable, const Message& first);

  std::string community_;
  VariableTable variables_;
  std::vector<ClientState> clients_;
};

}  // namespace limpet
