// SPDX-License-Identifier: MIT
// Bytes of a connection, packet after packet, and of a datagram: whatever is decoded must encode to
// the same bytes.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "limpet/wire/packet_codec.hpp"

using namespace limpet;  // NOLINT(google-build-using-namespace): one function

namespace {

void RequireSame(const WireMessage& message, ByteView raw) {
  ByteBuffer again;
  AppendMessage(message, again);
  if (!std::ranges::equal(again, raw)) {
    std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ByteView rest(reinterpret_cast<const std::byte*>(data), size);
  if (const auto message = DecodeMessage(rest)) {
    RequireSame(message->message, rest.first(message->size));
  }
  if (size >= kGreeting.size() && IsGreeting(rest)) {
    rest = rest.subspan(kGreeting.size());
  }
  while (rest.size() >= kPacketHeaderSize) {
    const auto header = DecodePacketHeader(rest);
    if (!header || header->size > rest.size()) {
      break;
    }
    PacketReader reader(rest.first(header->size));
    while (!reader.is_at_end()) {
      if (const auto message = reader.Next()) {
        RequireSame(*message, reader.raw());
      }
    }
    rest = rest.subspan(header->size);
  }
  return 0;
}
