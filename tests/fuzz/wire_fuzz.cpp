// SPDX-License-Identifier: MIT
// Bytes of a connection, and of a datagram: whatever is decoded must encode to the same bytes.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "limpet/wire/packet_codec.hpp"

using namespace limpet;  // NOLINT(google-build-using-namespace): one function

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const ByteView bytes(reinterpret_cast<const std::byte*>(data), size);
  if (const auto message = DecodeMessage(bytes)) {
    ByteBuffer again;
    AppendMessage(message->message, again);
    if (!std::equal(again.begin(), again.end(), bytes.begin(),
                    bytes.begin() + static_cast<std::ptrdiff_t>(message->size))) {
      std::abort();
    }
  }
  if (size >= kPacketHeaderSize) {
    const auto header = DecodePacketHeader(bytes);
    if (header && header->size <= size) {
      PacketReader reader(bytes.first(header->size));
      while (!reader.is_at_end()) {
        static_cast<void>(reader.Next());
      }
    }
  }
  return 0;
}
