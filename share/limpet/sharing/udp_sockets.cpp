// SPDX-License-Identifier: MIT
#include "limpet/sharing/udp_sockets.hpp"

#include <array>
#include <deque>
#include <map>
#include <mutex>
#include <thread>

#include <asio/io_context.hpp>
#include <asio/ip/multicast.hpp>
#include <asio/ip/udp.hpp>
#include <asio/post.hpp>
#include <asio/steady_timer.hpp>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace limpet {
namespace {

using asio::ip::udp;

constexpr std::size_t kLargestDatagram = 65'536;
constexpr std::size_t kDatagramCost = 128;   ///< of keeping one, besides its bytes
constexpr int kReceiveRoom = 1'792 * 1'024;  ///< of the system, as MOOS's
constexpr int kSendRoom = 256 * 1'024;
constexpr int kBurst = 64;  ///< datagrams of one input before the others' turn
constexpr auto kResolvePause = std::chrono::seconds(5);

Error TroubleWith(const ShareAddress& address, const std::error_code& code) {
  return Error{fmt::format("{}: {}", address.Text(), code.message())};
}

/// The address that `host` spells; nobody is asked for a name.
std::optional<asio::ip::address_v4> AddressOf(const std::string& host) {
  std::error_code error;
  const auto address =
      asio::ip::make_address_v4(host == "localhost" ? std::string("127.0.0.1") : host, error);
  return error ? std::nullopt : std::optional(address);
}

}  // namespace

std::string UdpPeer::Text() const {
  return fmt::format("{}:{}", asio::ip::address_v4(address).to_string(), port);
}

class UdpSockets::Impl {
 public:
  explicit Impl(std::function<void()> on_arrival)
      : on_arrival_(std::move(on_arrival)),
        guard_(asio::make_work_guard(context_)),
        resolver_(context_),
        replies_(context_),
        sender_(sending_) {
    replies_.id = kReplies;
    std::error_code ignored;
    sender_.open(udp::v4(), ignored);
    sender_.non_blocking(true, ignored);
    sender_.set_option(udp::socket::send_buffer_size(kSendRoom), ignored);
    sender_.set_option(asio::ip::multicast::hops(1), ignored);
    sender_.set_option(asio::ip::multicast::enable_loopback(true), ignored);
    sender_.bind({asio::ip::address_v4::any(), 0}, ignored);
    // A second handle on the same socket: one thread sends, the other one listens.
    replies_.socket.assign(udp::v4(), ::dup(sender_.native_handle()), ignored);
    replies_.socket.non_blocking(true, ignored);
    AwaitDatagram(replies_);
    thread_ = std::thread([this] { context_.run(); });
  }
  ~Impl() {
    context_.stop();
    thread_.join();
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  Expected<Input> Listen(const ShareAddress& address, const std::string& interface) {
    std::error_code error;
    const auto bound = asio::ip::make_address_v4(interface, error);
    if (error) {
      return Error{fmt::format("interface `{}` is no IPv4 address", interface)};
    }
    if (listeners_.size() >= kMostInputs) {
      return Error{fmt::format("more than {} inputs", kMostInputs)};
    }
    auto listener = std::make_unique<Listener>(context_);
    Open(listener->socket, address, bound, error);
    if (error) {
      return TroubleWith(address, error);
    }
    listener->id = listeners_.size();
    listener->port = listener->socket.local_endpoint(error).port();
    asio::post(context_, [this, &listener = *listener] { AwaitDatagram(listener); });
    listeners_.push_back(std::move(listener));
    return listeners_.size() - 1;
  }

  [[nodiscard]] std::uint16_t PortOf(Input input) const { return listeners_.at(input)->port; }

  void Resolve(const ShareAddress& address) {
    const std::lock_guard lock(mutex_);
    if (hosts_.contains(address.host)) {
      return;
    }
    if (const auto known = AddressOf(address.host)) {
      hosts_[address.host].address = *known;
      return;
    }
    hosts_[address.host].trouble = "not looked up yet";
    asio::post(context_, [this, host = address.host] { LookUp(host); });
  }

  std::optional<Error> Send(const ShareAddress& address, ByteView bytes) {
    udp::endpoint target;
    {
      const std::lock_guard lock(mutex_);
      const auto host = hosts_.find(address.host);
      if (host == hosts_.end() || !host->second.address) {
        return Error{fmt::format("{}: host {}", address.Text(),
                                 host == hosts_.end() ? "unknown" : host->second.trouble)};
      }
      target = udp::endpoint(*host->second.address, address.port);
    }
    std::error_code error;
    sender_.send_to(asio::const_buffer(bytes.data(), bytes.size()), target, 0, error);
    // Nobody listens there (yet): an answer to an earlier datagram, told to a later one.
    const bool is_old_news = error == asio::error::connection_refused;
    return error && !is_old_news ? std::optional(TroubleWith(address, error)) : std::nullopt;
  }

  void Reply(const Datagram& to, ByteView bytes) {
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(to.sender.port);
    place.sin_addr.s_addr = htonl(to.sender.address);
    const int socket = to.input == kReplies ? sender_.native_handle()
                                            : listeners_.at(to.input)->socket.native_handle();
    static_cast<void>(::sendto(socket, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL,
                               reinterpret_cast<const sockaddr*>(&place), sizeof place));
  }

  std::vector<Datagram> Take() {
    const std::lock_guard lock(mutex_);
    std::vector<Datagram> taken;
    taken.swap(arrived_);
    kept_.fill(0);
    return taken;
  }
  [[nodiscard]] std::uint64_t overflow() const {
    const std::lock_guard lock(mutex_);
    return overflow_;
  }

 private:
  struct Listener {
    explicit Listener(asio::io_context& context) : socket(context) {}
    udp::socket socket;
    Input id = 0;
    std::uint16_t port = 0;
  };
  struct Host {
    std::optional<asio::ip::address_v4> address;
    std::string trouble;
  };

  static void Open(udp::socket& socket, const ShareAddress& address,
                   const asio::ip::address_v4& bound, std::error_code& error) {
    socket.open(udp::v4(), error);
    std::error_code ignored;
    socket.set_option(udp::socket::receive_buffer_size(kReceiveRoom), ignored);
    if (!address.channel) {
      // Not reuse_address: for UDP it would let another program take our datagrams.
      error = error ? error : socket.bind({bound, address.port}, error);
    } else {
      const auto group = asio::ip::make_address_v4(address.host, ignored);
      socket.set_option(udp::socket::reuse_address(true), ignored);
      error = error ? error : socket.bind({group, address.port}, error);
      error =
          error ? error : socket.set_option(asio::ip::multicast::join_group(group, bound), error);
    }
    error = error ? error : socket.non_blocking(true, error);
  }

  void AwaitDatagram(Listener& listener) {
    listener.socket.async_wait(udp::socket::wait_read, [this, &listener](std::error_code error) {
      if (!error) {
        Receive(listener);
        AwaitDatagram(listener);
      }
    });
  }

  void Receive(Listener& listener) {
    bool is_news = false;
    for (int i = 0; i < kBurst; ++i) {
      udp::endpoint from;
      std::error_code error;
      const std::size_t size = listener.socket.receive_from(
          asio::mutable_buffer(scratch_.data(), scratch_.size()), from, 0, error);
      if (error == asio::error::would_block) {
        break;
      }
      if (!error) {
        is_news |= Keep(listener.id, {scratch_.data(), size}, from);
      }
    }
    if (is_news) {
      on_arrival_();
    }
  }

  /// True if there was nothing to take before.
  bool Keep(Input input, ByteView bytes, const udp::endpoint& from) {
    const std::lock_guard lock(mutex_);
    if (kept_.at(input) + bytes.size() + kDatagramCost > kQueuePerInput) {
      ++overflow_;
      return false;
    }
    kept_.at(input) += bytes.size() + kDatagramCost;
    arrived_.push_back(
        {.input = input,
         .sender = {.address = from.address().to_v4().to_uint(), .port = from.port()},
         .bytes = ByteBuffer(bytes.begin(), bytes.end())});
    return true;
  }

  void LookUp(const std::string& host) {
    resolver_.async_resolve(
        udp::v4(), host, "",
        [this, host](std::error_code error, const udp::resolver::results_type& results) {
          const std::lock_guard lock(mutex_);
          if (!error && !results.empty()) {
            hosts_[host].address = results.begin()->endpoint().address().to_v4();
            return;
          }
          hosts_[host].trouble = "cannot be found: " + error.message();
          auto timer = std::make_shared<asio::steady_timer>(context_, kResolvePause);
          timer->async_wait([this, host, timer](std::error_code) { LookUp(host); });
        });
  }

  std::function<void()> on_arrival_;
  asio::io_context context_;
  asio::executor_work_guard<asio::io_context::executor_type> guard_;
  udp::resolver resolver_;
  std::vector<std::unique_ptr<Listener>> listeners_;  ///< read by the owner's thread alone
  Listener replies_;
  std::array<std::byte, kLargestDatagram> scratch_{};

  mutable std::mutex mutex_;  ///< of what follows
  std::map<std::string, Host> hosts_;
  std::vector<Datagram> arrived_;
  std::array<std::size_t, kMostInputs + 1> kept_{};
  std::uint64_t overflow_ = 0;

  asio::io_context sending_;  ///< never run: the owner's thread sends
  udp::socket sender_;
  std::thread thread_;
};

UdpSockets::UdpSockets(std::function<void()> on_arrival)
    : impl_(std::make_unique<Impl>(std::move(on_arrival))) {}
UdpSockets::~UdpSockets() = default;
Expected<UdpSockets::Input> UdpSockets::Listen(const ShareAddress& address,
                                               const std::string& interface) {
  return impl_->Listen(address, interface);
}
std::uint16_t UdpSockets::PortOf(Input input) const { return impl_->PortOf(input); }
void UdpSockets::Resolve(const ShareAddress& address) { impl_->Resolve(address); }
std::optional<Error> UdpSockets::Send(const ShareAddress& address, ByteView bytes) {
  return impl_->Send(address, bytes);
}
void UdpSockets::Reply(const Datagram& to, ByteView bytes) { impl_->Reply(to, bytes); }
std::vector<UdpSockets::Datagram> UdpSockets::Take() { return impl_->Take(); }
std::uint64_t UdpSockets::overflow() const { return impl_->overflow(); }

}  // namespace limpet
