// SPDX-License-Identifier: MIT
// One accepted connection of the broker, TCP or local: greeting, hello, then packets both ways.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "limpet/pubsub/broker.hpp"
#include "limpet/pubsub/local_socket.hpp"
#include "limpet/pubsub/unit_reader.hpp"

namespace limpet {

/// Work of one readiness event is bounded: no client can keep the others waiting.
inline constexpr std::size_t kReadBudget = std::size_t{256} << 10;

class TcpConnection {
 public:
  /// kSilent: no greeting yet. kGreeted: no hello yet.
  enum class Stage { kSilent, kGreeted, kLive };
  /// What the sockets' owner is asked and told.
  struct Host {
    Broker* broker = nullptr;
    std::span<std::byte> scratch;  ///< shared by all: read here first
    std::function<Seconds()> moos_time;
    std::function<void(Broker::Client, TcpConnection&)> on_admitted;
  };

  TcpConnection(StreamSocket socket, Host& host);
  ~TcpConnection() { Forget(); }
  TcpConnection(const TcpConnection&) = delete;
  TcpConnection& operator=(const TcpConnection&) = delete;

  /// Reads and works off what has arrived.
  [[nodiscard]] UnitReader::End Read();
  /// For its UnitReader: bytes that the unit at the front takes in all.
  [[nodiscard]] Expected<std::optional<std::size_t>> UnitSize(ByteView bytes) const;
  [[nodiscard]] bool OnUnit(ByteView unit);
  [[nodiscard]] RoomKind MayHold(std::size_t now, std::size_t then);
  /// Frees what it holds, read and to be sent: the connection is to be closed.
  void Forget();
  /// Sends as much as the socket takes. False if the connection is to be closed.
  [[nodiscard]] bool Write();
  /// For who sends to several at once: what is to be sent next, if it is in one piece. Empty: leave
  /// it to Write(). Stays until OnSent().
  [[nodiscard]] ByteView NextPiece();
  /// The socket took that many bytes of what is to be sent.
  void OnSent(std::size_t bytes);

  /// Frees room that a burst has left, if all is sent.
  void GiveBack();

  [[nodiscard]] bool wants_to_write() const { return out_.unsent() > 0; }
  [[nodiscard]] StreamSocket& socket() { return socket_; }
  /// Nothing before its hello, and once it has been told why it may not enter.
  [[nodiscard]] std::optional<Broker::Client> client() const { return client_; }
  [[nodiscard]] Stage stage() const { return stage_; }
  [[nodiscard]] Seconds opened() const { return opened_; }
  [[nodiscard]] Seconds last_heard() const { return last_heard_; }
  /// When the socket last took bytes, or had nothing to take.
  [[nodiscard]] Seconds last_progress() const { return last_progress_; }

  /// True amid a large packet, which is read in turns.
  [[nodiscard]] bool is_large() const;
  /// Since when its packet is unfinished; nothing if none is.
  [[nodiscard]] std::optional<Seconds> unfinished_since() const { return unfinished_since_; }
  /// Room that its unfinished packet holds [bytes].
  [[nodiscard]] std::size_t held() const { return accounted_; }
  /// More room that it asked for in vain [bytes].
  [[nodiscard]] std::size_t wanted() const { return wanted_; }
  /// True if its packet comes so slowly that nobody means it.
  [[nodiscard]] bool IsDribbling(Seconds now) const;

  bool is_waiting_to_write = false;  ///< the owner has asked to be told when it may write

 private:
  [[nodiscard]] bool Greet(ByteView hello_packet);
  /// What is to be sent next, as pieces; gives how many. None: nothing is.
  [[nodiscard]] std::size_t NextPieces(std::span<ByteView> pieces);
  /// Starts on the next packet. False: there is none.
  [[nodiscard]] bool NextPacket();

  StreamSocket socket_;
  Host& host_;
  Stage stage_ = Stage::kSilent;
  std::optional<Broker::Client> client_;
  UnitReader reader_;
  std::size_t accounted_ = 0;  ///< in the broker's HeldMemory
  std::size_t wanted_ = 0;
  bool has_completed_ = false;  ///< a unit, in this reading
  std::optional<Seconds> unfinished_since_;
  OutgoingPacket out_;
  bool closes_when_sent_ = false;
  Seconds opened_, last_heard_, last_progress_;
};

}  // namespace limpet
