// SPDX-License-Identifier: MIT
#include "limpet/pubsub/tcp_client.hpp"

#include <asio/post.hpp>

#include "limpet/core/clock.hpp"
#include "limpet/pubsub/tcp_client_impl.hpp"
#include "limpet/pubsub/wildcard_text.hpp"
#include "limpet/wire/message_id.hpp"

namespace limpet {
namespace {

constexpr double kDirectPause = 30e-6;  ///< sends closer together than this are gathered [s]

}  // namespace

void TcpClient::Impl::Send(WireMessage message) {
  const std::lock_guard lock(mutex_);
  message.id = next_id_++;
  Queue(message);
}

void TcpClient::Impl::Post(WireMessage message, std::string_view source_aux) {
  const std::lock_guard lock(mutex_);
  message.id = next_id_++;
  message.source = options_.name;
  message.source_aux = source_aux;
  message.time = Now().value();
  Queue(message);
}

void TcpClient::Impl::Subscribe(const std::string& name, Seconds interval) {
  const std::lock_guard lock(mutex_);
  subscriptions_[name] = interval;
  if (state_ == State::kConnected) {
    SendSubscription(name, interval);
  }
}

void TcpClient::Impl::Unsubscribe(const std::string& name) {
  const std::lock_guard lock(mutex_);
  subscriptions_.erase(name);
  if (state_ == State::kConnected) {
    Control({.type = wire_type::kUnregister, .key = name, .number = 0.0});
  }
}

void TcpClient::Impl::SubscribeWildcard(const WildcardFilter& filter) {
  const std::lock_guard lock(mutex_);
  filters_.push_back(filter);
  if (state_ == State::kConnected) {
    SendFilter(filter);
  }
}

void TcpClient::Impl::Request(std::string_view what) {
  const std::lock_guard lock(mutex_);
  Queue({.id = message_id::kAnswer,
         .type = wire_type::kRequest,
         .data_type = wire_data::kString,
         .source = options_.name,
         .key = what,
         .time = Now().value()});
}

TcpClient::State TcpClient::Impl::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}
std::string TcpClient::Impl::trouble() const {
  const std::lock_guard lock(mutex_);
  return trouble_;
}
std::string TcpClient::Impl::community() const {
  const std::lock_guard lock(mutex_);
  return community_;
}
std::size_t TcpClient::Impl::unsent() const {
  const std::lock_guard lock(mutex_);
  return sender_.waiting();
}
std::uint64_t TcpClient::Impl::dropped() const {
  const std::lock_guard lock(mutex_);
  return sender_.dropped();
}

void TcpClient::Impl::SendSubscription(const std::string& name, Seconds interval) {
  Control({.type = wire_type::kRegister, .key = name, .number = interval.value()});
}

void TcpClient::Impl::SendFilter(const WildcardFilter& filter) {
  const std::string text = TextOf(filter);
  Control({.type = wire_type::kWildcardRegister,
           .data_type = wire_data::kString,
           .key = options_.name,
           .text = text});
}

void TcpClient::Impl::Control(WireMessage message) {
  message.id = next_id_++;
  message.source = options_.name;
  message.time = Now().value();
  Queue(message);
}

void TcpClient::Impl::Queue(const WireMessage& message) {
  sender_.Queue(message);
  if (state_ != State::kConnected || is_flush_due_) {
    return;
  }
  const bool is_quiet = (SteadyTime() - sender_.last_send()).value() >= kDirectPause;
  if (is_quiet && !sender_.is_in_packet()) {
    Flush();
  } else {
    is_flush_due_ = true;
    asio::post(context_, [this] {
      const std::lock_guard lock(mutex_);
      is_flush_due_ = false;
      Flush();
    });
  }
}

void TcpClient::Impl::Flush() {
  // A failure shows when reading, too: it is dealt with there.
  if (descriptor_ >= 0 &&
      sender_.Send(descriptor_, clock_.Own()) == ClientSender::Outcome::kBlocked) {
    WaitToWrite();
  }
}

void TcpClient::Impl::WaitToWrite() {
  if (is_flush_due_) {
    return;
  }
  is_flush_due_ = true;
  asio::post(context_, [this] {
    socket_.async_wait(StreamSocket::wait_write, [this](std::error_code) {
      const std::lock_guard lock(mutex_);
      is_flush_due_ = false;
      Flush();
    });
  });
}

TcpClient::TcpClient(TcpClientOptions options)
    : impl_(std::make_unique<Impl>(std::move(options))) {}
TcpClient::~TcpClient() = default;

void TcpClient::Publish(std::string_view name, double value, std::string_view source_aux) {
  impl_->Post({.key = name, .number = value}, source_aux);
}
void TcpClient::Publish(std::string_view name, std::string_view value,
                        std::string_view source_aux) {
  impl_->Post({.data_type = wire_data::kString, .key = name, .text = value}, source_aux);
}
void TcpClient::PublishValue(std::string_view name, const Value& value,
                             std::string_view source_aux) {
  if (const auto* number = std::get_if<double>(&value)) {
    Publish(name, *number, source_aux);
  } else if (const auto* text = std::get_if<std::string>(&value)) {
    Publish(name, std::string_view(*text), source_aux);
  } else {
    const auto& bytes = std::get<Binary>(value);
    impl_->Post({.data_type = wire_data::kBinary,
                 .key = name,
                 .text = {reinterpret_cast<const char*>(bytes.data()), bytes.size()}},
                source_aux);
  }
}
void TcpClient::Send(WireMessage message) { impl_->Send(message); }
void TcpClient::Subscribe(const std::string& name, Seconds interval) {
  impl_->Subscribe(name, interval);
}
void TcpClient::Unsubscribe(const std::string& name) { impl_->Unsubscribe(name); }
void TcpClient::SubscribeWildcard(const WildcardFilter& filter) {
  impl_->SubscribeWildcard(filter);
}
void TcpClient::Request(std::string_view what) { impl_->Request(what); }
TcpClient::State TcpClient::state() const { return impl_->state(); }
std::string TcpClient::trouble() const { return impl_->trouble(); }
std::string TcpClient::community() const { return impl_->community(); }
Seconds TcpClient::Now() const { return impl_->Now(); }
Seconds TcpClient::clock_disagreement() const { return impl_->clock_disagreement(); }
double TcpClient::warp() const { return impl_->warp(); }
std::size_t TcpClient::unsent() const { return impl_->unsent(); }
std::uint64_t TcpClient::dropped() const { return impl_->dropped(); }

}  // namespace limpet
