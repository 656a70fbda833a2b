// SPDX-License-Identifier: MIT
#include "limpet/pubsub/database.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/core/require.hpp"

namespace limpet {

bool MatchesWildcard(std::string_view pattern, std::string_view text) {
  // Greedy with one backtrack point: linear in practice, and no recursion for hostile patterns to
  // exhaust.
  std::size_t p = 0;
  std::size_t t = 0;
  std::size_t star = std::string_view::npos;
  std::size_t resume = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      resume = t;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t])) {
      ++p;
      ++t;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      t = ++resume;
    } else {
      return false;
    }
  }
  return pattern.substr(p).find_first_not_of('*') == std::string_view::npos;
}

Database::Database(std::string community) : community_(std::move(community)) {}

std::optional<Database::Client> Database::Connect(const std::string& name) {
  const bool is_taken = std::ranges::any_of(clients_, [&name](const ClientState& client) {
    return client.is_connected && client.name == name;
  });
  if (name.empty() || is_taken) {
    return std::nullopt;
  }
  clients_.push_back({.name = name, .is_connected = true, .filters = {}, .mail = {}});
  return clients_.size() - 1;
}

void Database::Disconnect(Client client) {
  LIMPET_REQUIRE(client < clients_.size(), "unknown client");
  for (auto& [name, variable] : variables_) {
    std::erase_if(variable.subscribers,
                  [client](const Subscriber& s) { return s.client == client; });
  }
  clients_[client] = ClientState{};
}

void Database::AddSubscriber(Variable& variable, Client client, Seconds interval) {
  std::erase_if(variable.subscribers, [client](const Subscriber& s) { return s.client == client; });
  const auto after = std::ranges::find_if(variable.subscribers, [&](const Subscriber& s) {
    return clients_[s.client].name > clients_[client].name;
  });
  variable.subscribers.insert(after, {.client = client, .interval = interval, .last_delivery = {}});
}

Database::Variable& Database::CreateVariable(const std::string& name) { return variables_[name]; }

void Database::Subscribe(Client client, const std::string& name, Seconds interval, Seconds now) {
  LIMPET_REQUIRE(client < clients_.size(), "unknown client");
  Variable& variable = CreateVariable(name);
  AddSubscriber(variable, client, interval);
  if (variable.latest) {
    Message latched = *variable.latest;
    latched.id = -1;
    clients_[client].mail.push_back(std::make_shared<const Message>(std::move(latched)));
    for (Subscriber& subscriber : variable.subscribers) {
      if (subscriber.client == client) {
        subscriber.last_delivery = now;
      }
    }
  }
}

void Database::Unsubscribe(Client client, std::string_view name) {
  const auto found = variables_.find(name);
  if (found != variables_.end()) {
    std::erase_if(found->second.subscribers,
                  [client](const Subscriber& s) { return s.client == client; });
  }
}

void Database::SubscribeWildcard(Client client, const WildcardFilter& filter, Seconds now) {
  clients_[client].filters.push_back(filter);
  for (const std::string& name : Variables()) {
    const MessagePtr latest = variables_.find(name)->second.latest;
    const std::string writer = latest ? latest->source : "";
    if (MatchesWildcard(filter.variable_pattern, name) &&
        MatchesWildcard(filter.app_pattern, writer)) {
      Subscribe(client, name, filter.interval, now);
    }
  }
}

void Database::UnsubscribeWildcard(Client client, const WildcardFilter& filter) {
  std::erase_if(clients_[client].filters, [&filter](const WildcardFilter& kept) {
    return kept.app_pattern == filter.app_pattern &&
           kept.variable_pattern == filter.variable_pattern;
  });
  for (const auto& [name, variable] : variables_) {
    const std::string writer = variable.latest ? variable.latest->source : "";
    if (MatchesWildcard(filter.variable_pattern, name) &&
        MatchesWildcard(filter.app_pattern, writer)) {
      Unsubscribe(client, name);
    }
  }
}

void Database::SubscribeMatchingClients(Variable& variable, const Message& first) {
  for (Client client = 0; client < clients_.size(); ++client) {
    const bool is_subscribed = std::ranges::any_of(
        variable.subscribers, [client](const Subscriber& s) { return s.client == client; });
    const auto filter =
        std::ranges::find_if(clients_[client].filters, [&first](const WildcardFilter& f) {
          return MatchesWildcard(f.variable_pattern, first.name) &&
                 MatchesWildcard(f.app_pattern, first.source);
        });
    if (!is_subscribed && filter != clients_[client].filters.end()) {
      AddSubscriber(variable, client, filter->interval);
    }
  }
}

Database::WriteResult Database::Write(Message message, Seconds now) {
  Variable& variable = CreateVariable(message.name);
  if (!variable.latest) {
    SubscribeMatchingClients(variable, message);
  } else if (variable.latest->value.index() != message.value.index()) {
    return WriteResult::kTypeMismatch;
  }
  if (message.community.empty()) {
    message.community = community_;
  }
  variable.latest = std::make_shared<const Message>(std::move(message));
  for (Subscriber& subscriber : variable.subscribers) {
    const double interval = subscriber.interval.value();  // not a number means never
    const bool is_due =
        interval <= 0.0 ||
        (!subscriber.last_delivery ? !std::isnan(interval)
                                   : (now - *subscriber.last_delivery).value() >= interval);
    if (is_due) {
      subscriber.last_delivery = now;
      clients_[subscriber.client].mail.push_back(variable.latest);
    }
  }
  return WriteResult::kStored;
}

std::vector<MessagePtr> Database::TakeMail(Client client) {
  std::vector<MessagePtr> mail;
  mail.swap(clients_[client].mail);
  return mail;
}

MessagePtr Database::Latest(std::string_view name) const {
  const auto found = variables_.find(name);
  return found == variables_.end() ? nullptr : found->second.latest;
}

std::vector<std::string> Database::Variables() const {
  std::vector<std::string> names;
  names.reserve(variables_.size());
  for (const auto& [name, variable] : variables_) {
    names.push_back(name);
  }
  std::ranges::sort(names);
  return names;
}

std::vector<std::string> Database::Clients() const {
  std::vector<std::string> names;
  for (const ClientState& client : clients_) {
    if (client.is_connected) {
      names.push_back(client.name);
    }
  }
  return names;
}

}  // namespace limpet
