// SPDX-License-Identifier: MIT
#include "limpet/pubsub/tcp_broker.hpp"

#include <list>
#include <stdexcept>

#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/post.hpp>
#include <asio/steady_timer.hpp>
#include <fmt/format.h>
#include <malloc.h>

#include "limpet/core/clock.hpp"
#include "limpet/pubsub/client_clock.hpp"
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
constexpr std::uint64_t kLooksToTrim = 4;
constexpr std::uint64_t kCalm = 1000;  ///< writes in a watch period: fewer, and a burst is over
constexpr std::size_t kSpareHeap = std::size_t{2} << 20;  ///< freed memory kept for what comes next

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
        scratch_(kScratch) {
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
  using Connections = std::list<TcpConnection>;

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
    if (Strangers() >= options_.handshakes) {
      return;  // closes it
    }
    std::error_code ignored;
    socket.non_blocking(true, ignored);
    socket.set_option(tcp::no_delay(true), ignored);  // a local one has no such delay
    connections_.emplace_back(std::move(socket), host_);
    WaitToRead(std::prev(connections_.end()));
  }

  [[nodiscard]] std::size_t Strangers() const {
    return static_cast<std::size_t>(std::ranges::count_if(
        connections_, [](const TcpConnection& c) { return !c.client().has_value(); }));
  }

  void WaitToRead(Connections::iterator connection) {
    connection->socket().async_wait(StreamSocket::wait_read,
                                    [this, connection](std::error_code error) {
                                      if (error || !connection->socket().is_open()) {
                                        return;  // closed meanwhile
                                      }
                                      const bool is_good = connection->Read();
                                      Keep();
                                      if (!is_good) {
                                        Close(connection);
                                      }
                                      Flush();  // first: what others wait for
                                      if (is_good) {
                                        FlushOne(*connection);
                                        WaitToRead(connection);
                                      }
                                    });
  }

  /// Sends what the broker has for anyone. A connection that fails here is closed by its own
  /// read: the socket then says so.
  void Flush() {
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
      for (auto it = connections_.begin(); it != connections_.end();) {
        const auto connection = it++;
        if (IsHopeless(*connection, now)) {
          Close(connection);
        } else {
          connection->GiveBack();
        }
      }
      Report();
      Flush();
      GiveBackHeap();
      Watch();
    });
  }

  /// What a burst has left lies between small things that stay: the allocator alone would keep it.
  void GiveBackHeap() {
    const std::uint64_t writes = broker_.counts().messages - writes_;
    writes_ += writes;
    if (++looks_ % kLooksToTrim == 0 && writes < kCalm && mallinfo2().fordblks > kSpareHeap) {
      malloc_trim(kSpareHeap / 4);
    }
  }

  void Report() {
    if (options_.report) {
      const Seconds now = MoosTime(options_.warp);
      for (const auto& [name, text] : options_.report(broker_, now)) {
        broker_.Publish(name, text, now);
      }
    }
  }

  [[nodiscard]] bool IsHopeless(const TcpConnection& connection, Seconds now) const {
    if (!connection.client()) {
      return now - connection.opened() > options_.handshake_timeout;
    }
    const bool is_stuck =
        connection.wants_to_write() && now - connection.last_progress() > options_.stuck_timeout;
    return is_stuck || now - connection.last_heard() > options_.client_timeout;
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
  bool is_keeping_ = false;   ///< keep_ is running
  std::uint64_t writes_ = 0;  ///< at the last look of Watch
  std::uint64_t looks_ = 0;
  ByteBuffer scratch_;
  TcpConnection::Host host_;
  Connections connections_;
  Connections graveyard_;             ///< closed, until their cancelled handlers have run
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
