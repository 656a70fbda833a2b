// SPDX-License-Identifier: MIT
#include "limpet/pubsub/tcp_client.hpp"

#include <map>
#include <mutex>
#include <thread>
#include <vector>

#include <asio/connect.hpp>
#include <asio/io_context.hpp>
#include <asio/post.hpp>
#include <asio/steady_timer.hpp>
#include <asio/write.hpp>

#include "limpet/core/clock.hpp"
#include "limpet/pubsub/client_clock.hpp"
#include "limpet/pubsub/client_sender.hpp"
#include "limpet/pubsub/unit_reader.hpp"
#include "limpet/pubsub/wildcard_text.hpp"

namespace limpet {
namespace {

using asio::ip::tcp;

constexpr double kDirectPause = 30e-6;  ///< sends closer together than this are gathered [s]
constexpr auto kIdlePeriod = std::chrono::milliseconds(333);
constexpr auto kLongestGoodbye = std::chrono::milliseconds(500);
constexpr double kFirstRetry = 0.1;  ///< [s], real time
constexpr double kLongestRetry = 1.0;
constexpr std::size_t kClientScratch = std::size_t{256} << 10;
constexpr std::size_t kClientReadBudget = std::size_t{4} << 20;

}  // namespace

class TcpClient::Impl {
 public:
  explicit Impl(TcpClientOptions options)
      : options_(std::move(options)),
        clock_(options_.warp),
        sender_(options_.queue),
        socket_(context_),
        resolver_(context_),
        timer_(context_),
        scratch_(kClientScratch) {
    asio::post(context_, [this] { Connect(); });
    thread_ = std::thread([this] { context_.run(); });
  }

  ~Impl() {
    // What was published last is worth a last attempt: a poke writes one value and leaves. The
    // broker's end of the connection must come first, or unread mail would turn our own close
    // into a reset that can overtake what we sent.
    asio::post(context_, [this] {
      const std::lock_guard lock(mutex_);
      is_leaving_ = true;
      Flush();
      if (state_ != State::kConnected) {
        context_.stop();
        return;
      }
      std::error_code ignored;
      socket_.shutdown(tcp::socket::shutdown_send, ignored);
      timer_.expires_after(kLongestGoodbye);
      timer_.async_wait([this](std::error_code) { context_.stop(); });
    });
    thread_.join();
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void Send(WireMessage message) {
    const std::lock_guard lock(mutex_);
    message.id = next_id_++;
    Queue(message);
  }

  void Post(WireMessage message, std::string_view source_aux) {
    const std::lock_guard lock(mutex_);
    message.id = next_id_++;
    message.source = options_.name;
    message.source_aux = source_aux;
    message.time = Now().value();
    Queue(message);
  }

  void Subscribe(const std::string& name, Seconds interval) {
    const std::lock_guard lock(mutex_);
    subscriptions_[name] = interval;
    if (state_ == State::kConnected) {
      SendSubscription(name, interval);
    }
  }

  void Unsubscribe(const std::string& name) {
    const std::lock_guard lock(mutex_);
    subscriptions_.erase(name);
    if (state_ == State::kConnected) {
      Control({.type = wire_type::kUnregister, .key = name, .number = 0.0});
    }
  }

  void SubscribeWildcard(const WildcardFilter& filter) {
    const std::lock_guard lock(mutex_);
    filters_.push_back(filter);
    if (state_ == State::kConnected) {
      SendFilter(filter);
    }
  }

  void Request(std::string_view what) {
    const std::lock_guard lock(mutex_);
    Queue({.id = -2,
           .type = wire_type::kRequest,
           .data_type = wire_data::kString,
           .source = options_.name,
           .key = what,
           .time = Now().value()});
  }

  [[nodiscard]] double warp() const { return clock_.warp(); }
  [[nodiscard]] Seconds Now() const { return clock_.Now(); }

  // For UnitReader.
  [[nodiscard]] Expected<std::optional<std::size_t>> UnitSize(ByteView bytes) const {
    if (bytes.size() < kPacketHeaderSize) {
      return std::optional<std::size_t>();
    }
    const auto header = DecodePacketHeader(bytes);
    if (!header) {
      return header.error();
    }
    return std::optional(header->size);
  }
  [[nodiscard]] bool OnUnit(ByteView unit) {
    PacketReader reader(unit);
    for (bool is_first = true; !reader.is_at_end(); is_first = false) {
      const auto message = reader.Next();
      if (!message) {
        return false;
      }
      if (!is_welcome_) {
        if (!Enter(*message)) {
          return false;
        }
      } else if (is_first && message->type == wire_type::kTiming) {
        clock_.TakeEcho(*message);
      } else if (message->type == wire_type::kNotify && options_.on_mail) {
        options_.on_mail(*message);
      }
    }
    return true;
  }

  TcpClientOptions options_;
  ClientClock clock_;
  mutable std::mutex mutex_;  ///< guards what any thread may touch: all down to `descriptor_`
  State state_ = State::kConnecting;
  std::string trouble_, community_;
  ClientSender sender_;

 private:
  void Connect() {
    socket_ = tcp::socket(context_);
    reader_ = UnitReader();
    is_welcome_ = false;
    resolver_.async_resolve(
        tcp::v4(), options_.host, std::to_string(options_.port),
        [this](std::error_code error, const tcp::resolver::results_type& places) {
          if (error) {
            Retry("cannot resolve " + options_.host + ": " + error.message());
            return;
          }
          asio::async_connect(socket_, places,
                              [this](std::error_code failure, const tcp::endpoint&) {
                                failure ? Retry(failure.message()) : Greet();
                              });
        });
  }

  void Greet() {
    socket_.set_option(tcp::no_delay(true));
    // Greeting and hello in one write: a stock broker takes a greeting in pieces for a wrong one.
    ByteBuffer hello(kGreeting.size());
    std::memcpy(hello.data(), kGreeting.data(), kGreeting.size());
    const ByteBuffer packet = PacketOf({.type = wire_type::kHello,
                                        .data_type = wire_data::kString,
                                        .key = "asynchronous",
                                        .time = clock_.Own().value(),
                                        .text = options_.name});
    hello.insert(hello.end(), packet.begin(), packet.end());
    std::error_code error;
    asio::write(socket_, asio::buffer(hello), error);
    socket_.non_blocking(true, error);
    if (error) {
      Retry(error.message());
      return;
    }
    WaitToRead();
  }

  void WaitToRead() {
    socket_.async_wait(tcp::socket::wait_read, [this](std::error_code error) {
      std::size_t received = 0;
      if (error || !reader_.Read(socket_, scratch_, kClientReadBudget, *this, received)) {
        Retry(refusal_.empty() ? "the broker closed the connection" : refusal_);
        return;
      }
      WaitToRead();
    });
  }

  /// The answer to the hello.
  bool Enter(const WireMessage& answer) {
    if (answer.type == wire_type::kPoison) {
      refusal_ = answer.text;
      return false;
    }
    is_welcome_ = true;
    clock_.TakeWelcome(answer, options_.learns_warp);
    retry_ = kFirstRetry;
    {
      const std::lock_guard lock(mutex_);
      community_ = answer.community;
      trouble_.clear();
      state_ = State::kConnected;
      descriptor_ = socket_.native_handle();
      sender_.Restart();
      for (const auto& [name, interval] : subscriptions_) {
        SendSubscription(name, interval);
      }
      for (const WildcardFilter& filter : filters_) {
        SendFilter(filter);
      }
      Flush();
    }
    Idle();
    TellState();
    return true;
  }

  void Retry(const std::string& why) {
    {
      const std::lock_guard lock(mutex_);
      trouble_ = why;
      descriptor_ = -1;
      state_ = refusal_.empty() ? State::kConnecting : State::kRefused;
      if (is_leaving_) {
        context_.stop();
        return;
      }
    }
    refusal_.clear();
    std::error_code ignored;
    socket_.close(ignored);
    TellState();
    timer_.expires_after(std::chrono::duration_cast<std::chrono::steady_clock::duration>(
        std::chrono::duration<double>(retry_)));
    retry_ = std::min(2.0 * retry_, kLongestRetry);
    timer_.async_wait([this](std::error_code error) {
      if (!error) {
        Connect();
      }
    });
  }

  /// Keeps the connection alive while there is nothing to say.
  void Idle() {
    timer_.expires_after(kIdlePeriod);
    timer_.async_wait([this](std::error_code error) {
      if (!error && is_welcome_) {
        {
          const std::lock_guard lock(mutex_);
          Flush();
          sender_.GiveBack();
        }
        Idle();
      }
    });
  }

  void TellState() {
    if (options_.on_state) {
      options_.on_state();
    }
  }

  // With mutex_ held, from here on.

  void SendSubscription(const std::string& name, Seconds interval) {
    Control({.type = wire_type::kRegister, .key = name, .number = interval.value()});
  }
  void SendFilter(const WildcardFilter& filter) {
    const std::string text = TextOf(filter);
    Control({.type = wire_type::kWildcardRegister,
             .data_type = wire_data::kString,
             .key = options_.name,
             .text = text});
  }
  void Control(WireMessage message) {
    message.id = next_id_++;
    message.source = options_.name;
    message.time = Now().value();
    Queue(message);
  }

  void Queue(const WireMessage& message) {
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

  void Flush() {
    // A failure shows when reading, too: it is dealt with there.
    if (descriptor_ >= 0 &&
        sender_.Send(descriptor_, clock_.Own()) == ClientSender::Outcome::kBlocked) {
      WaitToWrite();
    }
  }

  void WaitToWrite() {
    if (is_flush_due_) {
      return;
    }
    is_flush_due_ = true;
    asio::post(context_, [this] {
      socket_.async_wait(tcp::socket::wait_write, [this](std::error_code) {
        const std::lock_guard lock(mutex_);
        is_flush_due_ = false;
        Flush();
      });
    });
  }

  std::map<std::string, Seconds> subscriptions_;
  std::vector<WildcardFilter> filters_;
  std::int32_t next_id_ = 0;
  bool is_flush_due_ = false;
  bool is_leaving_ = false;
  int descriptor_ = -1;

  // The client's own thread alone.
  asio::io_context context_;
  tcp::socket socket_;
  tcp::resolver resolver_;
  asio::steady_timer timer_;
  UnitReader reader_;
  ByteBuffer scratch_;
  bool is_welcome_ = false;
  std::string refusal_;  ///< of the hello just sent
  double retry_ = kFirstRetry;
  std::thread thread_;
};

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
    const Binary& bytes = std::get<Binary>(value);
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
TcpClient::State TcpClient::state() const {
  const std::lock_guard lock(impl_->mutex_);
  return impl_->state_;
}
std::string TcpClient::trouble() const {
  const std::lock_guard lock(impl_->mutex_);
  return impl_->trouble_;
}
std::string TcpClient::community() const {
  const std::lock_guard lock(impl_->mutex_);
  return impl_->community_;
}
Seconds TcpClient::Now() const { return impl_->Now(); }
double TcpClient::warp() const { return impl_->warp(); }
std::size_t TcpClient::unsent() const {
  const std::lock_guard lock(impl_->mutex_);
  return impl_->sender_.waiting();
}
std::uint64_t TcpClient::dropped() const {
  const std::lock_guard lock(impl_->mutex_);
  return impl_->sender_.dropped();
}

}  // namespace limpet
