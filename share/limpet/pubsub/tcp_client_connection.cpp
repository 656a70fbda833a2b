// SPDX-License-Identifier: MIT
// The connection of a client: made, lost, made again with back-off; what comes in on it.
#include <asio/connect.hpp>
#include <asio/post.hpp>
#include <asio/write.hpp>

#include "limpet/pubsub/tcp_client_impl.hpp"

namespace limpet {
namespace {

using asio::ip::tcp;

constexpr auto kIdlePeriod = std::chrono::milliseconds(333);
constexpr auto kLongestGoodbye = std::chrono::milliseconds(500);
constexpr double kFirstRetry = 0.1;  ///< [s], real time
constexpr double kLongestRetry = 1.0;
constexpr std::size_t kClientScratch = std::size_t{256} << 10;
constexpr std::size_t kClientReadBudget = std::size_t{4} << 20;

}  // namespace

TcpClient::Impl::Impl(TcpClientOptions options)
    : options_(std::move(options)),
      clock_(options_.warp),
      sender_(options_.queue),
      socket_(context_),
      resolver_(context_),
      timer_(context_),
      keep_alive_(context_),
      scratch_(kClientScratch),
      retry_(kFirstRetry) {
  asio::post(context_, [this] { Connect(); });
  thread_ = std::thread([this] { context_.run(); });
}

TcpClient::Impl::~Impl() {
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
    socket_.shutdown(StreamSocket::shutdown_send, ignored);
    timer_.expires_after(kLongestGoodbye);
    timer_.async_wait([this](std::error_code) { context_.stop(); });
  });
  thread_.join();
}

Expected<std::optional<std::size_t>> TcpClient::Impl::UnitSize(ByteView bytes) const {
  if (bytes.size() < kPacketHeaderSize) {
    return std::optional<std::size_t>();
  }
  const auto header = DecodePacketHeader(bytes);
  if (!header) {
    return header.error();
  }
  return std::optional(header->size);
}

bool TcpClient::Impl::OnUnit(ByteView unit) {
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

void TcpClient::Impl::Connect() {
  socket_ = StreamSocket(context_);
  reader_ = UnitReader();
  is_welcome_ = false;
  resolver_.async_resolve(tcp::v4(), options_.host, std::to_string(options_.port),
                          [this](std::error_code error, const tcp::resolver::results_type& places) {
                            if (error) {
                              Retry("cannot resolve " + options_.host + ": " + error.message());
                              return;
                            }
                            Reach(places);
                          });
}

/// The broker of this machine by its local socket, if it has one; any other by TCP.
void TcpClient::Impl::Reach(const tcp::resolver::results_type& places) {
  if (auto local = options_.may_go_locally
                       ? ConnectLocally(context_.get_executor(),
                                        places.begin()->endpoint().address(), options_.port)
                       : std::nullopt) {
    socket_ = std::move(*local);
    Greet();
    return;
  }
  auto socket = std::make_shared<tcp::socket>(context_);
  asio::async_connect(*socket, places,
                      [this, socket](std::error_code failure, const tcp::endpoint&) {
                        if (failure) {
                          Retry(failure.message());
                          return;
                        }
                        std::error_code ignored;
                        socket->set_option(tcp::no_delay(true), ignored);
                        socket_ = StreamSocket(std::move(*socket));
                        Greet();
                      });
}

void TcpClient::Impl::Greet() {
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

void TcpClient::Impl::WaitToRead() {
  const auto room = reader_.Room(scratch_, *this);
  if (!room) {
    Retry("the broker sent what is no packet");
    return;
  }
  // Not async_wait: that would arm the reactor anew for every message.
  socket_.async_read_some(
      asio::buffer(room->data(), room->size()),
      [this, room](std::error_code error, std::size_t count) {
        std::size_t more = 0;
        const bool is_full = count == room->size();
        if (error || !reader_.Take(room->first(count), *this) ||
            (is_full && reader_.Read(socket_, scratch_, kClientReadBudget, *this, more) ==
                            UnitReader::End::kClosed)) {
          Retry(refusal_.empty() ? "the broker closed the connection" : refusal_);
          return;
        }
        WaitToRead();
      });
}

bool TcpClient::Impl::Enter(const WireMessage& answer) {
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

void TcpClient::Impl::Retry(const std::string& why) {
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
  is_welcome_ = false;  // ends the keep-alive, also one whose time has come already
  keep_alive_.cancel();
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

void TcpClient::Impl::Idle() {
  keep_alive_.expires_after(kIdlePeriod);
  keep_alive_.async_wait([this](std::error_code error) {
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

void TcpClient::Impl::TellState() {
  if (options_.on_state) {
    options_.on_state();
  }
}

}  // namespace limpet
