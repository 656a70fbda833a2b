// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "limpet/core/units.hpp"
#include "limpet/pubsub/wildcard.hpp"
#include "limpet/wire/wire_message.hpp"

namespace limpet {

/// Who hears what: clients, variables, subscriptions with intervals, wildcards, the type lock.
/// Semantics are MOOS's: a wildcard is shorthand for subscribing to each variable that matches.
/// It holds no values and no mail; the embedded database and the TCP broker keep theirs beside it,
/// indexed by its ids. Not thread-safe: one thread owns it.
class Router {
 public:
  /// Small numbers, used again after a client has left.
  using Client = std::uint32_t;
  /// Small numbers in order of creation, never used again.
  using Variable = std::uint32_t;
  static constexpr char kUnset = wire_data::kUnset;

  enum class WriteResult { kStored, kTypeMismatch };

  struct VariableInfo {
    std::string name;
    char type = kUnset;                ///< of the first write: D, S or B
    std::string last_writer;           ///< judged by wildcards' app pattern
    std::vector<std::string> writers;  ///< all since the last Clear, sorted
    std::uint64_t writes = 0;
    Seconds written;  ///< time of the last write
  };

  /// Nothing if the name is empty or in use.
  [[nodiscard]] std::optional<Client> Connect(const std::string& name);
  /// Forgets the client's subscriptions and filters; variables stay.
  void Disconnect(Client client);

  /// The variable of that name, created if need be.
  Variable Intern(std::string_view name);
  [[nodiscard]] std::optional<Variable> Find(std::string_view name) const;

  /// Enters or replaces a subscription and restarts its interval. True if the variable has a
  /// value, which is now to be sent (also when repeated). `interval` 0 or below lets every write
  /// pass; otherwise writes that come too soon are dropped for this client; NaN means never.
  [[nodiscard]] bool Subscribe(Client client, Variable variable, Seconds interval, Seconds now);
  void Unsubscribe(Client client, Variable variable);
  /// Subscribes to all that matches now (judged by the last writer) and to what is first written
  /// later. Gives the variables whose values are now to be sent, by name.
  [[nodiscard]] std::vector<Variable> SubscribeWildcard(Client client, const WildcardFilter& filter,
                                                        Seconds now);
  /// Drops the matching subscriptions and the filter itself.
  void UnsubscribeWildcard(Client client, const WildcardFilter& filter);

  /// Notes a write and calls `deliver(client)` for each subscriber that is due, in order of client
  /// name. The first write fixes the type; another type is refused.
  template <class Deliver>
  WriteResult Write(Variable id, char type, std::string_view source, Seconds now,
                    Deliver&& deliver) {
    Entry& entry = variables_[id];
    if (entry.info.type != type) {
      if (entry.info.type != kUnset) {
        return WriteResult::kTypeMismatch;
      }
      NoteFirstWrite(entry, type, source);
    }
    if (entry.info.last_writer != source) {
      NoteWriter(entry.info, source);
    }
    ++entry.info.writes;
    entry.info.written = now;
    for (Subscriber& subscriber : entry.subscribers) {
      if (IsDue(subscriber, now)) {
        subscriber.last_delivery = now;
        deliver(subscriber.client);
      }
    }
    return WriteResult::kStored;
  }

  /// Forgets that anything was written: types, writers, counts. Subscriptions stay.
  void Clear();

  [[nodiscard]] std::size_t variable_count() const { return variables_.size(); }
  [[nodiscard]] const VariableInfo& Info(Variable id) const { return variables_[id].info; }
  [[nodiscard]] const std::string& NameOf(Client client) const { return clients_[client].name; }
  /// All variables by name.
  [[nodiscard]] std::vector<Variable> Sorted() const;
  /// Names of connected clients, in order of their ids.
  [[nodiscard]] std::vector<std::string> Clients() const;
  [[nodiscard]] std::size_t FilterCount(Client client) const {
    return clients_[client].filters.size();
  }
  /// Names of the variables that `client` is subscribed to, sorted.
  [[nodiscard]] std::vector<std::string> SubscriptionsOf(Client client) const;

 private:
  struct Subscriber {
    Client client = 0;
    Seconds interval;
    std::optional<Seconds> last_delivery;
  };
  struct Entry {
    VariableInfo info;
    std::vector<Subscriber> subscribers;  ///< in order of client name, as MOOS delivers
  };
  struct ClientState {
    std::string name;
    bool is_connected = false;
    std::vector<WildcardFilter> filters;
  };

  [[nodiscard]] static bool IsDue(const Subscriber& subscriber, Seconds now) {
    const double interval = subscriber.interval.value();
    if (interval <= 0.0) {
      return true;
    }
    return subscriber.last_delivery ? (now - *subscriber.last_delivery).value() >= interval
                                    : !std::isnan(interval);
  }
  void NoteFirstWrite(Entry& entry, char type, std::string_view source);
  static void NoteWriter(VariableInfo& info, std::string_view source);
  Subscriber& AddSubscriber(Entry& entry, Client client, Seconds interval);
  [[nodiscard]] static bool Matches(const WildcardFilter& filter, const VariableInfo& info);

  std::deque<Entry> variables_;  ///< a deque: names stay where by_name_ looks at them
  std::unordered_map<std::string_view, Variable> by_name_;
  std::vector<ClientState> clients_;
};

}  // namespace limpet
