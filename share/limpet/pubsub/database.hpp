// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/message.hpp"
#include "limpet/pubsub/router.hpp"

namespace limpet {

/// The publish-subscribe database of one process: a Router with messages that are shared in memory.
/// Not thread-safe: one thread owns it.
class Database {
 public:
  using Client = Router::Client;
  using WriteResult = Router::WriteResult;

  explicit Database(std::string community);

  /// Nothing if the name is empty or in use.
  [[nodiscard]] std::optional<Client> Connect(const std::string& name);
  /// Forgets subscriptions, filters and mail; variables stay.
  void Disconnect(Client client);

  /// Subscribes, and queues the current value at once if there is one, also when repeated.
  /// `interval` 0 or below delivers every write; otherwise writes that come too soon are dropped
  /// for this client.
  void Subscribe(Client client, std::string_view variable, Seconds interval, Seconds now);
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
  [[nodiscard]] bool HasMail(Client client) const { return !mail_[client].empty(); }

  [[nodiscard]] MessagePtr Latest(std::string_view variable) const;
  /// Names of all variables, sorted.
  [[nodiscard]] std::vector<std::string> Variables() const;
  /// Names of connected clients.
  [[nodiscard]] std::vector<std::string> Clients() const { return router_.Clients(); }
  [[nodiscard]] const std::string& community() const { return community_; }

 private:
  void SendLatest(Client client, Router::Variable variable);

  std::string community_;
  Router router_;
  std::vector<MessagePtr> latest_;             ///< by variable
  std::vector<std::vector<MessagePtr>> mail_;  ///< by client
};

}  // namespace limpet
