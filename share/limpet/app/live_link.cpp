// SPDX-License-Identifier: MIT
#include "limpet/app/live_link.hpp"

#include <chrono>

#include "limpet/core/clock.hpp"
#include "limpet/wire/message_conversion.hpp"

namespace limpet {
namespace {

/// An app that has not taken its mail for this long will not miss the oldest.
constexpr std::size_t kInboxLimit = 200'000;

}  // namespace

TcpClientOptions LiveLink::Listening(TcpClientOptions options) {
  options.on_mail = [this](const WireMessage& message) {
    auto owned = std::make_shared<const Message>(MessageFrom(message));
    const std::lock_guard lock(mutex_);
    if (inbox_.size() < kInboxLimit && heard_.IsNews(*owned)) {
      inbox_.push_back(std::move(owned));
      arrival_.notify_one();
    }
  };
  options.on_state = [this] {
    {
      const std::lock_guard lock(mutex_);
      heard_.StartConnection();
    }
    Wake();
  };
  return options;
}

LiveLink::LiveLink(TcpClientOptions options) : client_(Listening(std::move(options))) {}

void LiveLink::Publish(std::string name, Value value, std::string source_aux) {
  published_.insert(name);
  if (!is_replaying()) {
    client_.PublishValue(name, value, source_aux);
  }
}
void LiveLink::Forward(const Message& message) {
  published_.insert(message.name);
  if (!is_replaying()) {
    client_.Send(ViewOf(message));
  }
}
void LiveLink::Subscribe(const std::string& name, Seconds interval) {
  subscribed_.insert(name);
  if (!is_replaying()) {
    const std::lock_guard lock(mutex_);
    heard_.Forget(name);
  }
  client_.Subscribe(name, interval);
}
void LiveLink::SubscribeWildcard(const WildcardFilter& filter) {
  subscribed_.insert(filter.variable_pattern);
  client_.SubscribeWildcard(filter);
}

std::vector<MessagePtr> LiveLink::TakeMail(Seconds deadline) {
  std::unique_lock lock(mutex_);
  const double wait = (deadline - SteadyTime()).value();
  if (inbox_.empty() && !is_woken_ && wait > 0.0) {
    arrival_.wait_for(lock, std::chrono::duration<double>(wait),
                      [this] { return !inbox_.empty() || is_woken_; });
  }
  is_woken_ = false;
  std::vector<MessagePtr> mail;
  mail.swap(inbox_);
  return mail;
}

void LiveLink::NoteHeard(const Message& message) {
  const std::lock_guard lock(mutex_);
  heard_.NoteFormer(message);
}

void LiveLink::Replay(std::optional<Seconds> now) { replayed_ = now; }

void LiveLink::Wake() {
  const std::lock_guard lock(mutex_);
  is_woken_ = true;
  arrival_.notify_one();
}

}  // namespace limpet
