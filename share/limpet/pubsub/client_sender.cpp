// SPDX-License-Identifier: MIT
#include "limpet/pubsub/client_sender.hpp"

#include <algorithm>
#include <array>
#include <cerrno>

#include <sys/socket.h>
#include <sys/uio.h>

#include "limpet/core/clock.hpp"

namespace limpet {
namespace {

constexpr double kTimingPeriod = 1.0;  ///< real time [s]
constexpr std::size_t kPieces = 32;    ///< of one gathering write

}  // namespace

void ClientSender::Queue(const WireMessage& message) {
  if (EncodedSize(message) < kShareFrom) {
    encoded_.clear();
    AppendMessage(message, encoded_);
    outbox_.Append(0, encoded_);
  } else {
    auto encoded = std::make_shared<ByteBuffer>();
    AppendMessage(message, *encoded);
    outbox_.Append(0, std::move(encoded));
  }
}

void ClientSender::Restart() {
  sent_ = 0;
  last_timing_ = Seconds(0.0);
}

ClientSender::Outcome ClientSender::Send(int descriptor, Seconds now) {
  Outcome outcome = Outcome::kAllSent;
  while (outcome == Outcome::kAllSent && (unsent() > 0 || Assemble(now))) {
    const ssize_t count = SendSome(descriptor);
    last_send_ = SteadyTime();
    if (count >= 0) {
      sent_ += static_cast<std::size_t>(count);
    } else {
      outcome = errno == EAGAIN || errno == EWOULDBLOCK ? Outcome::kBlocked : Outcome::kFailed;
    }
  }
  outbox_.SetInFlight(unsent());
  return outcome;
}

void ClientSender::GiveBack() {
  if (unsent() == 0) {
    body_.Clear();
    body_.GiveBack();
    outbox_.GiveBack();
  }
}

/// The next packet, in head_ and body_; timing leads it when due. False: nothing to say.
bool ClientSender::Assemble(Seconds now) {
  const Seconds steady = SteadyTime();
  const bool is_timing_due = (steady - last_timing_).value() >= kTimingPeriod;
  head_.clear();
  body_.Clear();
  sent_ = 0;
  if (!is_timing_due && outbox_.empty()) {
    return false;
  }
  head_.assign(kPacketHeaderSize, std::byte{0});
  if (is_timing_due) {
    last_timing_ = steady;
    AppendMessage(
        {.type = wire_type::kTiming, .key = "_async_timing", .time = now.value(), .number = 0.0},
        head_);
  }
  const std::size_t count = outbox_.Take(body_) + (is_timing_due ? 1 : 0);
  EncodePacketHeader({unsent(), count}, head_.data());
  return true;
}

ssize_t ClientSender::SendSome(int descriptor) const {
  std::array<ByteView, kPieces> pieces;
  const std::size_t in_head = std::min(sent_, head_.size());
  pieces[0] = ByteView(head_).subspan(in_head);
  const std::size_t filled = 1 + body_.Gather(sent_ - in_head, std::span(pieces).subspan(1));
  std::array<iovec, kPieces> parts{};
  for (std::size_t i = 0; i < filled; ++i) {
    parts[i] = {.iov_base = const_cast<std::byte*>(pieces[i].data()),  // sendmsg only reads
                .iov_len = pieces[i].size()};
  }
  msghdr message{};
  message.msg_iov = parts.data();
  message.msg_iovlen = filled;
  return ::sendmsg(descriptor, &message, MSG_NOSIGNAL | MSG_DONTWAIT);
}

}  // namespace limpet
