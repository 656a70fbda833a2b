// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "limpet/pubsub/outgoing_packet.hpp"

namespace limpet {

/// All bytes that a connection would send, whatever their pieces.
inline ByteBuffer BytesOf(const Parcel& parcel) {
  ByteBuffer bytes;
  std::array<ByteView, 3> pieces;
  while (const std::size_t count = parcel.Gather(bytes.size(), pieces)) {
    for (std::size_t i = 0; i < count; ++i) {
      bytes.insert(bytes.end(), pieces[i].begin(), pieces[i].end());
    }
  }
  return bytes;
}

/// Of a packet that is not yet sent.
inline ByteBuffer BytesOf(const OutgoingPacket& packet) {
  ByteBuffer bytes = packet.lead;
  const ByteBuffer mail = BytesOf(packet.mail);
  bytes.insert(bytes.end(), mail.begin(), mail.end());
  return bytes;
}

}  // namespace limpet
