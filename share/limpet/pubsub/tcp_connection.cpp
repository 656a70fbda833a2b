// SPDX-License-Identifier: MIT
#include "limpet/pubsub/tcp_connection.hpp"

#include <array>

#include <asio/buffer.hpp>
#include <fmt/format.h>

#include "limpet/core/clock.hpp"

namespace limpet {
namespace {

/// A hello is a name; nobody has a reason to send more before being known.
constexpr std::size_t kMaxHello = std::size_t{4} << 10;
/// An unfinished packet of that size is nobody's concern [bytes].
constexpr std::size_t kSmall = std::size_t{16} << 10;
/// From here on a packet is read in turns with other large ones [bytes].
constexpr std::size_t kLarge = std::size_t{64} << 10;
/// What is read at a time while memory is short: it may have to be kept [bytes].
constexpr std::size_t kCautious = std::size_t{4} << 10;
constexpr Seconds kPatience(10.0);       ///< with any unfinished packet
constexpr double kSlowest = 4.0 * 1024;  ///< at which one may come after that [bytes/s]

}  // namespace

TcpConnection::TcpConnection(StreamSocket socket, Host& host)
    : socket_(std::move(socket)),
      host_(host),
      opened_(SteadyTime()),
      last_heard_(opened_),
      last_progress_(opened_) {}

Expected<std::optional<std::size_t>> TcpConnection::UnitSize(ByteView bytes) const {
  if (stage_ == Stage::kSilent) {
    return std::optional<std::size_t>(kGreeting.size());
  }
  if (bytes.size() < kPacketHeaderSize) {
    return std::optional<std::size_t>();
  }
  const auto header = DecodePacketHeader(bytes, client_ ? kMaxPacketSize : kMaxHello);
  if (!header) {
    return header.error();
  }
  return std::optional(header->size);
}

UnitReader::End TcpConnection::Read() {
  HeldMemory& memory = host_.broker->memory();
  const auto scratch =
      memory.HasRoomFor(host_.scratch.size()) ? host_.scratch : host_.scratch.first(kCautious);
  std::size_t received = 0;
  has_completed_ = false;
  wanted_ = 0;
  const std::size_t budget = is_large() && memory.IsGettingShort() ? kLarge : kReadBudget;
  const UnitReader::End end = reader_.Read(socket_, scratch, budget, *this, received);
  memory.ResizeUnfinished(accounted_, reader_.held());
  accounted_ = reader_.held();
  if (received > 0) {
    last_heard_ = SteadyTime();
  }
  if (!reader_.is_amid()) {
    unfinished_since_.reset();
  } else if (has_completed_ || !unfinished_since_) {
    unfinished_since_ = last_heard_;
  }
  return end;
}

RoomKind TcpConnection::MayHold(std::size_t now, std::size_t then) {
  HeldMemory& memory = host_.broker->memory();
  // What Append took for the beginning is not accounted yet.
  memory.ResizeUnfinished(accounted_, now);
  accounted_ = now;
  if (then > kSmall && !memory.HasRoomFor(then - now)) {
    wanted_ = then - now;
    return RoomKind::kNone;
  }
  memory.ResizeUnfinished(now, then);
  accounted_ = then;
  return then > kLarge && memory.IsGettingShort() ? RoomKind::kMapped : RoomKind::kHeap;
}

void TcpConnection::Forget() {
  host_.broker->memory().ResizeUnfinished(accounted_, 0);
  accounted_ = 0;
  reader_ = UnitReader();
  unfinished_since_.reset();
  out_ = {};
}

bool TcpConnection::is_large() const {
  return reader_.is_amid() && reader_.Announced(*this) > kLarge;
}

bool TcpConnection::IsDribbling(Seconds now) const {
  return unfinished_since_ &&
         now - *unfinished_since_ >
             kPatience + Seconds(static_cast<double>(reader_.arrived()) / kSlowest);
}

bool TcpConnection::OnUnit(ByteView unit) {
  has_completed_ = true;
  switch (stage_) {
    case Stage::kSilent:
      stage_ = Stage::kGreeted;
      return IsGreeting(unit);
    case Stage::kGreeted:
      return Greet(unit);
    case Stage::kLive:
      return closes_when_sent_ || !host_.broker->Receive(*client_, unit, host_.moos_time());
  }
  return false;
}

bool TcpConnection::Greet(ByteView packet) {
  PacketReader reader(packet);
  if (reader.is_at_end()) {
    return false;
  }
  const auto hello = reader.Next();
  if (!hello) {
    return false;
  }
  Broker::Admission admission = host_.broker->Admit(*hello, host_.moos_time());
  stage_ = Stage::kLive;
  out_ = OutgoingPacket(std::move(admission.answer));
  client_ = admission.client;
  closes_when_sent_ = !client_;
  if (client_) {
    host_.on_admitted(*client_, *this);
  }
  return Write();
}

bool TcpConnection::NextPacket() {
  last_progress_ = SteadyTime();
  if (closes_when_sent_) {
    // The client closes when it has read why; closing here could take the words away from it.
    std::error_code ignored;
    socket_.shutdown(StreamSocket::shutdown_send, ignored);
    out_ = {};
    return false;
  }
  return client_ && host_.broker->TakePacket(*client_, out_, host_.moos_time());
}

std::size_t TcpConnection::NextPieces(std::span<ByteView> pieces) {
  return out_.unsent() > 0 || NextPacket() ? out_.Gather(pieces) : 0;
}

ByteView TcpConnection::NextPiece() {
  std::array<ByteView, 2> pieces;
  return NextPieces(pieces) == 1 ? pieces[0] : ByteView();
}

void TcpConnection::OnSent(std::size_t bytes) {
  out_.Took(bytes);
  if (out_.unsent() > 0) {
    out_.ForgetSent();
    last_progress_ = bytes > 0 ? SteadyTime() : last_progress_;
  }
  if (client_) {
    host_.broker->outbox(*client_).SetInFlight(out_.unsent(), out_.unsent() > 0 ? out_.own() : 0);
  }
}

bool TcpConnection::Write() {
  std::array<ByteView, kPiecesPerWrite> pieces;
  while (const std::size_t filled = NextPieces(pieces)) {
    std::array<asio::const_buffer, kPiecesPerWrite> parts;
    std::ranges::transform(std::span(pieces).first(filled), parts.begin(), [](ByteView piece) {
      return asio::const_buffer(piece.data(), piece.size());
    });
    std::error_code error;
    const std::size_t count = filled == 1
                                  ? socket_.write_some(parts.front(), error)
                                  : socket_.write_some(std::span(parts).first(filled), error);
    if (error && error != asio::error::would_block) {
      return false;
    }
    OnSent(count);
    if (error) {
      break;
    }
  }
  return true;
}

void TcpConnection::GiveBack() {
  if (out_.unsent() == 0) {
    out_.GiveBack();
    if (client_) {
      host_.broker->outbox(*client_).GiveBack();
    }
  }
}

}  // namespace limpet
