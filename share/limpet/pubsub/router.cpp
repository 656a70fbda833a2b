// SPDX-License-Identifier: MIT
#include "limpet/pubsub/router.hpp"

#include <algorithm>

#include "limpet/core/require.hpp"

namespace limpet {

std::optional<Router::Client> Router::Connect(const std::string& name) {
  const bool is_taken = std::ranges::any_of(clients_, [&name](const ClientState& client) {
    return client.is_connected && client.name == name;
  });
  if (name.empty() || is_taken) {
    return std::nullopt;
  }
  auto slot =
      std::ranges::find_if(clients_, [](const auto& client) { return !client.is_connected; });
  if (slot == clients_.end()) {
    slot = clients_.insert(slot, ClientState{});
  }
  *slot = {.name = name, .is_connected = true, .filters = {}};
  return static_cast<Client>(slot - clients_.begin());
}

void Router::Disconnect(Client client) {
  LIMPET_REQUIRE(client < clients_.size(), "unknown client");
  for (Entry& entry : variables_) {
    std::erase_if(entry.subscribers, [client](const Subscriber& s) { return s.client == client; });
  }
  clients_[client] = ClientState{};
}

Router::Variable Router::Intern(std::string_view name) {
  const auto found = by_name_.find(name);
  if (found != by_name_.end()) {
    return found->second;
  }
  const auto id = static_cast<Variable>(variables_.size());
  variables_.push_back(
      {.info = {.name = std::string(name), .last_writer = {}, .writers = {}, .written = {}},
       .subscribers = {}});
  by_name_.emplace(variables_.back().info.name, id);
  return id;
}

std::optional<Router::Variable> Router::Find(std::string_view name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? std::nullopt : std::optional(found->second);
}

Router::Subscriber& Router::AddSubscriber(Entry& entry, Client client, Seconds interval) {
  std::erase_if(entry.subscribers, [client](const Subscriber& s) { return s.client == client; });
  const auto after = std::ranges::find_if(entry.subscribers, [&](const Subscriber& s) {
    return clients_[s.client].name > clients_[client].name;
  });
  return *entry.subscribers.insert(after,
                                   {.client = client, .interval = interval, .last_delivery = {}});
}

bool Router::Subscribe(Client client, Variable variable, Seconds interval, Seconds now) {
  LIMPET_REQUIRE(client < clients_.size(), "unknown client");
  Entry& entry = variables_[variable];
  Subscriber& subscriber = AddSubscriber(entry, client, interval);
  const bool has_value = entry.info.type != kUnset;
  if (has_value) {
    subscriber.last_delivery = now;
  }
  return has_value;
}

void Router::Unsubscribe(Client client, Variable variable) {
  std::erase_if(variables_[variable].subscribers,
                [client](const Subscriber& s) { return s.client == client; });
}

bool Router::Matches(const WildcardFilter& filter, const VariableInfo& info) {
  return MatchesWildcard(filter.variable_pattern, info.name) &&
         MatchesWildcard(filter.app_pattern, info.last_writer);
}

std::vector<Router::Variable> Router::SubscribeWildcard(Client client, const WildcardFilter& filter,
                                                        Seconds now) {
  clients_[client].filters.push_back(filter);
  std::vector<Variable> to_send;
  for (const Variable id : Sorted()) {
    if (Matches(filter, variables_[id].info) && Subscribe(client, id, filter.interval, now)) {
      to_send.push_back(id);
    }
  }
  return to_send;
}

void Router::UnsubscribeWildcard(Client client, const WildcardFilter& filter) {
  std::erase_if(clients_[client].filters, [&filter](const WildcardFilter& kept) {
    return kept.app_pattern == filter.app_pattern &&
           kept.variable_pattern == filter.variable_pattern;
  });
  for (Variable id = 0; id < variables_.size(); ++id) {
    if (Matches(filter, variables_[id].info)) {
      Unsubscribe(client, id);
    }
  }
}

void Router::NoteFirstWrite(Entry& entry, char type, std::string_view source) {
  entry.info.type = type;
  for (Client client = 0; client < clients_.size(); ++client) {
    const bool is_subscribed = std::ranges::any_of(
        entry.subscribers, [client](const Subscriber& s) { return s.client == client; });
    const auto& filters = clients_[client].filters;
    const auto filter = std::ranges::find_if(filters, [&](const WildcardFilter& f) {
      return MatchesWildcard(f.variable_pattern, entry.info.name) &&
             MatchesWildcard(f.app_pattern, source);
    });
    if (!is_subscribed && filter != filters.end()) {
      AddSubscriber(entry, client, filter->interval);
    }
  }
}

void Router::NoteWriter(VariableInfo& info, std::string_view source) {
  info.last_writer = source;
  const auto place = std::ranges::lower_bound(info.writers, source);
  if (place == info.writers.end() || *place != source) {
    info.writers.emplace(place, source);
  }
}

void Router::Clear() {
  for (Entry& entry : variables_) {
    VariableInfo& info = entry.info;  // the name stays in its place: by_name_ looks at it
    info.type = kUnset;
    info.last_writer.clear();
    info.writers.clear();
    info.writes = 0;
    info.written = Seconds(0.0);
  }
}

std::vector<Router::Variable> Router::Sorted() const {
  std::vector<Variable> ids(variables_.size());
  for (Variable id = 0; id < ids.size(); ++id) {
    ids[id] = id;
  }
  std::ranges::sort(ids, {},
                    [this](Variable id) -> const std::string& { return variables_[id].info.name; });
  return ids;
}

std::vector<std::string> Router::Clients() const {
  std::vector<std::string> names;
  for (const ClientState& client : clients_) {
    if (client.is_connected) {
      names.push_back(client.name);
    }
  }
  return names;
}

std::vector<std::string> Router::SubscriptionsOf(Client client) const {
  std::vector<std::string> names;
  for (const Variable id : Sorted()) {
    if (std::ranges::any_of(variables_[id].subscribers,
                            [client](const Subscriber& s) { return s.client == client; })) {
      names.push_back(variables_[id].info.name);
    }
  }
  return names;
}

}  // namespace limpet
