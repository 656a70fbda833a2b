// SPDX-License-Identifier: MIT
#include "limpet/pubsub/tcp_broker.hpp"

#include <algorithm>
#include <stdexcept>

#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/post.hpp>
#include <asio/steady_timer.hpp>
#include <fmt/format.h>

#include "limpet/core/clock.hpp"
#include "limpet/pubsub/client_clock.hpp"
#include "limpet/pubsub/connection_order.hpp"
#include "limpet/pubsub/heap_trim.hpp"
#include "limpet/pubsub/large_reads.hpp"
#include "limpet/pubsub/send_batch.hpp"
#include "limpet/pubsub/tcp_connection.hpp"
#include "limpet/pubsub/value_keeper.hpp"

namespace limpet {
namespace {

using asio::ip::tcp;

constexpr auto kWatchPeriod = std::chrono::milliseconds(500);
constexpr auto kKeepPeriod = std::chrono::milliseconds(200);
constexpr double kStatusPeriod = 2.0;  // MOOS time [s]
constexpr std::size_t kScratch = std::size_t{256} << 10;
constexpr Seconds kSlept(1.5);  ///< between two looks of Watch
constexpr Seconds kYoung(1.0);  ///< an unfinished packet that young has not lost its chance yet

std::chrono::steady_clock::duration Real(double seconds) {
  return std::chrono::duration_cast<std::chrono::steady_clock::duration>(
      std::chrono::duration<double>(seconds));
}

TcpBrokerOptions OnOwnClock(TcpBrokerOptions options) {
  options.broker.hostname = HostWords(options.broker.hostname);
  return options;
}

}  // namespace

class TcpBroker::Impl {
 public:
  explicit Impl(TcpBrokerOptions options)
      : options_(OnOwnClock(std::move(options))),
        broker_(options_.broker, MoosTime(options_.warp)),
        acceptor_(context_),
        local_acceptor_(context_),
        watch_(context_),
        status_(context_),
        pause_(context_),
        local_pause_(context_),
        keep_(context_),
        scratch_(kScratch),
        large_reads_(context_, broker_.memory(),
                     {.read = [this](auto connection) { return ReadFrom(connection); },
                      .wait = [this](auto connection) { WaitToRead(connection); },
                      .make_room = [this] { return CutUnfinished(kYoung); }}) {
    host_ = {.broker = &broker_,
             .scratch = scratch_,
             .moos_time = [this] { return MoosTime(options_.warp); },
             .on_admitted =
                 [this](Broker::Client client, TcpConnection& connection) {
                   live_.resize(std::max<std::size_t>(live_.size(), client + 1));
                   live_[client] = &connection;
                 }};
    Listen();
    ListenLocally();
    if (options_.kept_descriptor >= 0) {
      keeper_.emplace(options_.kept_descriptor, options_.kept, broker_);
    }
    Accept(acceptor_, pause_);
    if (local_acceptor_.is_open()) {
      Accept(local_acceptor_, local_pause_);
    }
    Watch();
    PublishStatus();
  }

  void Run() { context_.run(); }
  void Stop() { context_.stop(); }
  [[nodiscard]] std::uint16_t port() const { return acceptor_.local_endpoint().port(); }

 private:
  void Listen() {
    try {
      const tcp::endpoint place(asio::ip::make_address(options_.bind_address), options_.port);
      acceptor_.open(place.protocol());
      acceptor_.set_option(tcp::acceptor::reuse_address(true));
      acceptor_.bind(place);
      acceptor_.listen();
    } catch (const std::system_error& error) {
      throw std::runtime_error(fmt::format("cannot listen on {}:{}: {}", options_.bind_address,
                                           options_.port, error.code().message()));
    }
  }

  /// For programs of this machine. Who has that name already would get our clients: an error.
  void ListenLocally() {
    const auto place = LocalPlaceOf(acceptor_.local_endpoint().address(), port());
    std::error_code unknown;
    local_acceptor_.open(asio::local::stream_protocol(), unknown);
    if (unknown || !place) {
      local_acceptor_.close(unknown);
      return;  // a system without such sockets: they come by TCP
    }
    try {
      local_acceptor_.bind(*place);
      local_acceptor_.listen();
    } catch (const std::system_error& error) {
      throw std::runtime_error(fmt::format("cannot listen on the local socket @{}: {}",
                                           place->path().substr(1), error.code().message()));
    }
  }

  template <class Acceptor>
  void Accept(Acceptor& acceptor, asio::steady_timer& pause) {
    acceptor.async_accept([this, &acceptor, &pause](std::error_code error, auto socket) {
      if (error) {
        // Out of file descriptors, most likely: those who are in must not suffer for it.
        if (error == asio::error::no_descriptors) {
          static_cast<void>(DismissStranger());
        }
        pause.expires_after(std::chrono::milliseconds(100));
        pause.async_wait([this, &acceptor, &pause](std::error_code) { Accept(acceptor, pause); });
        return;
      }
      StreamSocket stream(std::move(socket));
      if constexpr (!std::is_same_v<Acceptor, tcp::acceptor>) {
        WidenLocal(stream);
      }
      Welcome(std::move(stream));
      Accept(acceptor, pause);
    });
  }

  void Welcome(StreamSocket socket) {
    while (CountStrangers(connections_) >= options_.handshakes && DismissStranger()) {
    }
    std::error_code ignored;
    socket.non_blocking(true, ignored);
    socket.set_option(tcp::no_delay(true), ignored);  // a local one has no such delay
    connections_.emplace_back(std::move(socket), host_);
    WaitToRead(std::prev(connections_.end()));
  }

  /// The longest silent one makes room, unless its hello has come meanwhile. False: there is none.
  [[nodiscard]] bool DismissStranger() {
    const auto oldest = OldestStranger(connections_);
    if (oldest == connections_.end()) {
      return false;
    }
    const bool is_closed = ReadFrom(oldest) == UnitReader::End::kClosed;
    if (!is_closed && oldest->client()) {
      return true;
    }
    ++broker_.counts().strangers;
    if (!is_closed) {
      Close(oldest);
    }
    return true;
  }

  void WaitToRead(Connections::iterator connection) {
    connection->socket().async_wait(StreamSocket::wait_read,
                                    [this, connection](std::error_code error) {
                                      if (error || !connection->socket().is_open()) {
                                        return;  // closed meanwhile
                                      }
                                      if (connection->is_large()) {
                                        large_reads_.Add(connection);
                                      } else {
                                        large_reads_.Continue(connection, ReadFrom(connection));
                                      }
                                    });
  }

  UnitReader::End ReadFrom(Connections::iterator connection) {
    const UnitReader::End end = connection->Read();
    Keep();
    if (end == UnitReader::End::kClosed) {
      Close(connection);
    }
    Flush();  // first: what others wait for
    if (!connection->socket().is_open()) {
      return UnitReader::End::kClosed;
    }
    FlushOne(*connection);
    return end;
  }

  [[nodiscard]] bool CutUnfinished(Seconds least_age) {
    const auto costliest = CostliestUnfinished(connections_, SteadyTime(), least_age);
    if (costliest == connections_.end()) {
      return false;
    }
    ++broker_.counts().unfinished;
    Close(costliest);
    return true;
  }

  /// Mail that connections hold, or packets that began while there was room, can be too much.
  void BoundMemory() {
    const HeldMemory& memory = broker_.memory();
    if (memory.IsUnfinishedTooMuch() || memory.queued() > memory.RoomForMail()) {
      broker_.BoundMail();  // the last count is of some time ago
    }
    while (broker_.memory().IsUnfinishedTooMuch() && CutUnfinished(Seconds(0.0))) {
    }
    while (broker_.memory().queued() > broker_.memory().RoomForMail()) {
      const auto stalled = LongestStalled(connections_);
      if (stalled == connections_.end()) {
        return;
      }
      ++broker_.counts().stalled;
      Close(stalled);
      broker_.BoundMail();
    }
  }

  /// Sends what the broker has for anyone. A connection that fails here is closed by its own
  /// read: the socket then says so.
  void Flush() {
    BoundMemory();
    const std::vector<Broker::Client> ready = broker_.TakeReady();
    if (ready.size() > 1 && batch_.is_open() && options_.may_send_together) {
      FlushTogether(ready);
    }
    for (const Broker::Client client : ready) {
      FlushOne(*live_[client]);
    }
  }

  /// The short packets of several at once; what is left of them, or fails, is FlushOne's.
  void FlushTogether(std::span<const Broker::Client> ready) {
    together_.clear();
    for (const Broker::Client client : ready) {
      TcpConnection& connection = *live_[client];
      const ByteView bytes = connection.is_waiting_to_write ? ByteView() : connection.NextPiece();
      if (!bytes.empty()) {
        batch_.Add(connection.socket().native_handle(), bytes);
        together_.push_back(&connection);
      }
    }
    const std::span<const int> taken = batch_.Send();
    for (std::size_t i = 0; i < taken.size(); ++i) {
      together_[i]->OnSent(static_cast<std::size_t>(std::max(0, taken[i])));
    }
  }

  /// Before anybody hears of it: what a client has seen stored is there after a restart.
  void Keep() {
    if (keeper_ && !broker_.news().empty()) {
      keeper_->Keep(SteadyTime());
      KeepWaiting();
    }
  }

  void KeepWaiting() {
    if (is_keeping_ || !keeper_->has_waiting()) {
      return;
    }
    is_keeping_ = true;
    keep_.expires_after(kKeepPeriod);
    keep_.async_wait([this](std::error_code error) {
      is_keeping_ = false;
      if (!error) {
        keeper_->KeepWaiting(SteadyTime());
        KeepWaiting();
      }
    });
  }

  void FlushOne(TcpConnection& connection) {
    if (connection.is_waiting_to_write) {
      return;
    }
    if (!connection.Write()) {
      std::error_code ignored;
      connection.socket().shutdown(StreamSocket::shutdown_both, ignored);
    } else if (connection.wants_to_write()) {
      connection.is_waiting_to_write = true;
      connection.socket().async_wait(StreamSocket::wait_write,
                                     [this, &connection](std::error_code error) {
                                       if (!error && connection.socket().is_open()) {
                                         connection.is_waiting_to_write = false;
                                         FlushOne(connection);
                                       }
                                     });
    }
  }

  void Close(Connections::iterator connection) {
    if (const auto client = connection->client()) {
      live_[*client] = nullptr;
      broker_.Leave(*client, MoosTime(options_.warp));
    }
    std::error_code ignored;
    connection->socket().close(ignored);  // cancels its waits: their handlers see an error
    connection->Forget();
    large_reads_.Remove(connection);
    graveyard_.splice(graveyard_.end(), connections_, connection);
    asio::post(context_, [this] { graveyard_.clear(); });
  }

  void Watch() {
    watch_.expires_after(kWatchPeriod);
    watch_.async_wait([this](std::error_code error) {
      if (error) {
        return;
      }
      const Seconds now = SteadyTime();
      // This process was stopped: what clients said meanwhile is read first.
      const bool has_slept = now - watched_ > kSlept;
      watched_ = now;
      for (auto it = connections_.begin(); it != connections_.end();) {
        const auto connection = it++;
        std::uint64_t* const count = has_slept ? nullptr : WhyHopeless(*connection, now);
        if (count != nullptr) {
          ++*count;
          Close(connection);
        } else {
          connection->GiveBack();
        }
      }
      broker_.BoundMail();
      Report();
      Flush();
      heap_.Look(broker_.counts().messages);
      Watch();
    });
  }

  void Report() {
    if (options_.report) {
      const Seconds now = MoosTime(options_.warp);
      for (const auto& [name, text] : options_.report(broker_, now)) {
        broker_.Publish(name, text, now);
      }
    }
  }

  /// The count that a hopeless connection is to be booked under; nullptr if it may stay.
  [[nodiscard]] std::uint64_t* WhyHopeless(const TcpConnection& connection, Seconds now) {
    BrokerCounts& counts = broker_.counts();
    if (!connection.client()) {
      return now - connection.opened() > options_.handshake_timeout ? &counts.strangers : nullptr;
    }
    if (connection.wants_to_write() && now - connection.last_progress() > options_.stuck_timeout) {
      return &counts.stalled;
    }
    if (connection.IsDribbling(now)) {
      return &counts.unfinished;
    }
    return now - connection.last_heard() > options_.client_timeout ? &counts.silent : nullptr;
  }

  void PublishStatus() {
    status_.expires_after(Real(kStatusPeriod / options_.warp));
    status_.async_wait([this](std::error_code error) {
      if (!error) {
        broker_.PublishStatus(MoosTime(options_.warp));
        Flush();
        PublishStatus();
      }
    });
  }

  TcpBrokerOptions options_;
  Broker broker_;
  asio::io_context context_{1};  // one thread: no locks inside
  tcp::acceptor acceptor_;
  asio::local::stream_protocol::acceptor local_acceptor_;
  asio::steady_timer watch_, status_, pause_, local_pause_, keep_;
  std::optional<ValueKeeper> keeper_;
  bool is_keeping_ = false;  ///< keep_ is running
  HeapTrim heap_;
  Seconds watched_ = SteadyTime();
  ByteBuffer scratch_;
  TcpConnection::Host host_;
  Connections connections_;
  Connections graveyard_;  ///< closed, until their cancelled handlers have run
  LargeReads large_reads_;
  std::vector<TcpConnection*> live_;  ///< by client
  SendBatch batch_;
  std::vector<TcpConnection*> together_;  ///< whose bytes are in batch_
};

TcpBroker::TcpBroker(TcpBrokerOptions options)
    : impl_(std::make_unique<Impl>(std::move(options))) {}
TcpBroker::~TcpBroker() = default;
void TcpBroker::Run() { impl_->Run(); }
void TcpBroker::Stop() { impl_->Stop(); }
std::uint16_t TcpBroker::port() const { return impl_->port(); }

}  // namespace limpet
