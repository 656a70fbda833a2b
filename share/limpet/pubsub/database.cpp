// SPDX-License-Identifier: MIT
#include "limpet/pubsub/database.hpp"

#include <algorithm>

#include "limpet/wire/message_id.hpp"

namespace limpet {

Database::Database(std::string community) : community_(std::move(community)) {}

std::optional<Database::Client> Database::Connect(const std::string& name) {
  const std::optional<Client> client = router_.Connect(name);
  if (client) {
    mail_.resize(std::max<std::size_t>(mail_.size(), *client + 1));
  }
  return client;
}

void Database::Disconnect(Client client) {
  router_.Disconnect(client);
  mail_[client].clear();
}

void Database::SendLatest(Client client, Router::Variable variable) {
  Message latched = *latest_[variable];
  latched.id = message_id::kLatest;
  mail_[client].push_back(std::make_shared<const Message>(std::move(latched)));
}

void Database::Subscribe(Client client, std::string_view name, Seconds interval, Seconds now) {
  const Router::Variable variable = router_.Intern(name);
  if (router_.Subscribe(client, variable, interval, now)) {
    SendLatest(client, variable);
  }
}

void Database::Unsubscribe(Client client, std::string_view name) {
  if (const auto variable = router_.Find(name)) {
    router_.Unsubscribe(client, *variable);
  }
}

void Database::SubscribeWildcard(Client client, const WildcardFilter& filter, Seconds now) {
  for (const Router::Variable variable : router_.SubscribeWildcard(client, filter, now)) {
    SendLatest(client, variable);
  }
}

void Database::UnsubscribeWildcard(Client client, const WildcardFilter& filter) {
  router_.UnsubscribeWildcard(client, filter);
}

Database::WriteResult Database::Write(Message message, Seconds now) {
  if (message.community.empty()) {
    message.community = community_;
  }
  constexpr std::string_view kTypes = "DSB";  // in the order of Value's alternatives
  const Router::Variable variable = router_.Intern(message.name);
  latest_.resize(router_.variable_count());
  const char type = kTypes[message.value.index()];
  const auto written = std::make_shared<const Message>(std::move(message));
  const WriteResult result =
      router_.Write(variable, type, written->source, now,
                    [&](Client client) { mail_[client].push_back(written); });
  if (result == WriteResult::kStored) {
    latest_[variable] = written;
  }
  return result;
}

std::vector<MessagePtr> Database::TakeMail(Client client) {
  std::vector<MessagePtr> mail;
  mail.swap(mail_[client]);
  return mail;
}

MessagePtr Database::Latest(std::string_view name) const {
  const auto variable = router_.Find(name);
  return variable && *variable < latest_.size() ? latest_[*variable] : nullptr;
}

std::vector<std::string> Database::Variables() const {
  std::vector<std::string> names;
  for (const Router::Variable variable : router_.Sorted()) {
    names.push_back(router_.Info(variable).name);
  }
  return names;
}

}  // namespace limpet
