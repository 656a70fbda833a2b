// SPDX-License-Identifier: MIT
// A client's whole connection, whatever its bytes: the broker lives, and all that it sends, to this
// client and to one that hears everything, are packets that can be read.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "limpet/pubsub/broker.hpp"
#include "tests/support/outgoing_bytes.hpp"

using namespace limpet;  // NOLINT(google-build-using-namespace): one program

namespace {

const Seconds kNow(100.0);

Broker::Client Enter(Broker& broker, const char* name, const char* kind) {
  const WireMessage hello{.type = wire_type::kHello, .key = kind, .text = name};
  return *broker.Admit(hello, kNow).client;
}

/// The first whole packet of `bytes`, which it takes away; empty if there is none.
ByteView TakePacket(ByteView& bytes) {
  if (bytes.size() >= kPacketHeaderSize) {
    const auto header = DecodePacketHeader(bytes);
    if (header && header->size <= bytes.size()) {
      const ByteView packet = bytes.first(header->size);
      bytes = bytes.subspan(header->size);
      return packet;
    }
  }
  return {};
}

void Drain(Broker& broker) {
  OutgoingPacket packet;
  for (const Broker::Client ready : broker.TakeReady()) {
    while (broker.TakePacket(ready, packet, kNow)) {
      const ByteBuffer sent = BytesOf(packet);
      ByteView rest = sent;
      for (PacketReader reader(TakePacket(rest)); !reader.is_at_end();) {
        if (!reader.Next()) {
          std::abort();
        }
      }
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Broker broker({.community = "alpha", .hostname = "h", .limits = {.queue = 1 << 16}}, kNow);
  const Broker::Client listener = Enter(broker, "pListener", "asynchronous");
  const ByteBuffer wish = PacketOf({.type = wire_type::kWildcardRegister,
                                    .data_type = wire_data::kString,
                                    .source = "pListener",
                                    .key = "pListener",
                                    .text = "AppPattern=*,VarPattern=*,Interval=0"});
  static_cast<void>(broker.Receive(listener, wish, kNow));
  ByteView rest(reinterpret_cast<const std::byte*>(data), size);
  if (size >= kGreeting.size() && IsGreeting(rest)) {
    rest = rest.subspan(kGreeting.size());
  }
  std::optional<Broker::Client> client;
  for (ByteView packet = TakePacket(rest); !packet.empty(); packet = TakePacket(rest)) {
    PacketReader reader(packet);
    const bool has_hello = !client && !reader.is_at_end();
    const auto hello = has_hello ? reader.Next() : Expected<WireMessage>(Error{"known"});
    if (hello && hello->type == wire_type::kHello) {
      client = broker.Admit(*hello, kNow).client;
      if (!client) {
        break;
      }
      continue;
    }
    client = client ? client : Enter(broker, "pFuzz", size % 2 == 0 ? "asynchronous" : "");
    if (broker.Receive(*client, packet, kNow)) {
      break;
    }
    Drain(broker);
  }
  broker.PublishStatus(kNow + Seconds(2.0));
  Drain(broker);
  if (client) {
    broker.Leave(*client, kNow);
  }
  // And as what a former broker has left.
  Broker next({.community = "alpha", .hostname = "h", .limits = {}}, kNow);
  next.Restore({reinterpret_cast<const std::byte*>(data), size}, kNow);
  next.PublishStatus(kNow);
  return 0;
}
