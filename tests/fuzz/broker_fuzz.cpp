// SPDX-License-Identifier: MIT
// One packet from a client that is in, whatever its bytes: the broker lives, and a second client
// is still served.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "limpet/pubsub/broker.hpp"

using namespace limpet;  // NOLINT(google-build-using-namespace): one function

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Seconds now(100.0);
  Broker broker({.community = "alpha", .hostname = "h", .limits = {}}, now);
  const WireMessage hello{.type = wire_type::kHello, .key = "asynchronous", .text = "pFuzz"};
  const auto client = broker.Admit(hello, now).client;
  const ByteView bytes(reinterpret_cast<const std::byte*>(data), size);
  if (size >= kPacketHeaderSize) {
    const auto header = DecodePacketHeader(bytes);
    if (header && header->size <= size) {
      static_cast<void>(broker.Receive(*client, bytes.first(header->size), now));
    }
  }
  broker.PublishStatus(now + Seconds(2.0));
  Broker::Outgoing packet;
  for (const Broker::Client ready : broker.TakeReady()) {
    static_cast<void>(broker.TakePacket(ready, packet, now));
  }
  broker.Leave(*client, now);
  return 0;
}
