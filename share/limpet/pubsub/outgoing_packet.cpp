// SPDX-License-Identifier: MIT
#include "limpet/pubsub/outgoing_packet.hpp"

#include <algorithm>
#include <array>

#include "limpet/core/require.hpp"

namespace limpet {
namespace {

/// Up to this size copying mail behind the header costs less than telling the system of two pieces.
constexpr std::size_t kShort = std::size_t{4} << 10;

}  // namespace

void OutgoingPacket::Begin() {
  lead.assign(kPacketHeaderSize, std::byte{0});
  mail.Clear();
  sent_ = 0;
}

void OutgoingPacket::Seal(std::size_t messages) {
  EncodePacketHeader({unsent(), messages}, lead.data());
  if (mail.size() <= kShort) {
    std::array<ByteView, 1> piece;
    for (std::size_t at = 0; mail.Gather(at, piece) > 0; at += piece[0].size()) {
      lead.insert(lead.end(), piece[0].begin(), piece[0].end());
    }
    mail.Clear();
  }
}

void OutgoingPacket::Clear() {
  lead.clear();
  mail.Clear();
  sent_ = 0;
}

void OutgoingPacket::GiveBack() {
  LIMPET_REQUIRE(unsent() == 0, "a packet that is being sent keeps its room");
  Clear();
  mail.GiveBack();
}

std::size_t OutgoingPacket::Gather(std::span<ByteView> pieces) const {
  const std::size_t in_lead = std::min(sent_, lead.size());
  std::size_t filled = 0;
  if (in_lead < lead.size()) {
    pieces[filled++] = ByteView(lead).subspan(in_lead);
  }
  return filled + mail.Gather(sent_ - in_lead, pieces.subspan(filled));
}

void OutgoingPacket::ForgetSent() { mail.LetGo(sent_ - std::min(sent_, lead.size())); }

}  // namespace limpet
