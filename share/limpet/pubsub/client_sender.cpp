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
  packet_.Rewind();
  last_timing_ = Seconds(0.0);
}

ClientSender::Outcome ClientSender::Send(int descriptor, Seconds now) {
  Outcome outcome = Outcome::kAllSent;
  while (outcome == Outcome::kAllSent && (packet_.unsent() > 0 || Assemble(now))) {
    const ssize_t count = SendSome(descriptor);
    last_send_ = SteadyTime();
    if (count >= 0) {
      packet_.Took(static_cast<std::size_t>(count));
    } else {
      outcome = errno == EAGAIN || errno == EWOULDBLOCK ? Outcome::kBlocked : Outcome::kFailed;
    }
  }
  outbox_.SetInFlight(packet_.unsent());
  return outcome;
}

void ClientSender::GiveBack() {
  if (packet_.unsent() == 0) {
    packet_.GiveBack();
    outbox_.GiveBack();
  }
}

/// The next packet; timing leads it when due. False: nothing to say.
bool ClientSender::Assemble(Seconds now) {
  const Seconds steady = SteadyTime();
  const bool is_timing_due = (steady - last_timing_).value() >= kTimingPeriod;
  if (!is_timing_due && outbox_.empty()) {
    packet_.Clear();
    return false;
  }
  packet_.Begin();
  if (is_timing_due) {
    last_timing_ = steady;
    AppendMessage(
        {.type = wire_type::kTiming, .key = "_async_timing", .time = now.value(), .number = 0.0},
        packet_.lead);
  }
  packet_.Seal(outbox_.Take(packet_.mail) + (is_timing_due ? 1 : 0));
  return true;
}

ssize_t ClientSender::SendSome(int descriptor) const {
  std::array<ByteView, kPiecesPerWrite> pieces;
  const std::size_t filled = packet_.Gather(pieces);
  if (filled == 1) {
    return ::send(descriptor, pieces[0].data(), pieces[0].size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  }
  std::array<iovec, kPiecesPerWrite> parts{};
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
