// SPDX-License-Identifier: MIT
#include "limpet/wire/packet_codec.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "limpet/core/require.hpp"
#include "limpet/wire/little_endian.hpp"

namespace limpet {

bool IsGreeting(ByteView bytes) {
  LIMPET_REQUIRE(bytes.size() >= kGreeting.size(), "a greeting has 32 bytes");
  // Up to and with the first NUL: what follows it is padding, and nobody agreed on its bytes.
  const std::size_t text = kGreeting.find('\0') + 1;
  return std::equal(kGreeting.begin(), kGreeting.begin() + text, bytes.begin(),
                    [](char expected, std::byte given) {
                      return std::toupper(static_cast<unsigned char>(expected)) ==
                             std::toupper(std::to_integer<unsigned char>(given));
                    });
}

Expected<PacketHeader> DecodePacketHeader(ByteView bytes, std::size_t max_size) {
  LIMPET_REQUIRE(bytes.size() >= kPacketHeaderSize, "a packet header has 9 bytes");
  const auto size = Get<std::int32_t>(bytes.data());
  const auto count = Get<std::int32_t>(bytes.data() + 4);
  if (size < static_cast<std::int32_t>(kPacketHeaderSize) ||
      static_cast<std::size_t>(size) > max_size) {
    return Error{
        fmt::format("packet of {} bytes; allowed: {} to {}", size, kPacketHeaderSize, max_size)};
  }
  const std::size_t body = static_cast<std::size_t>(size) - kPacketHeaderSize;
  if (count < 0 || static_cast<std::size_t>(count) > body / kMessageFixedSize) {
    return Error{fmt::format("{} messages in a packet of {} bytes", count, size)};
  }
  return PacketHeader{static_cast<std::size_t>(size), static_cast<std::size_t>(count)};
}

void EncodePacketHeader(const PacketHeader& header, std::byte* out) {
  LIMPET_REQUIRE(header.size <= INT32_MAX, "a packet beyond 2 GiB");
  out = Put(out, static_cast<std::int32_t>(header.size));
  out = Put(out, static_cast<std::int32_t>(header.count));
  Put(out, char{0});  // compression, which no version uses
}

PacketReader::PacketReader(ByteView packet)
    : rest_(packet.subspan(kPacketHeaderSize)),
      left_(static_cast<std::size_t>(Get<std::int32_t>(packet.data() + 4))) {}

Expected<WireMessage> PacketReader::Next() {
  if (left_ == 0) {
    const std::size_t spare = rest_.size();
    rest_ = {};
    return Error{fmt::format("{} bytes after the last message of a packet", spare)};
  }
  const Expected<DecodedMessage> decoded = DecodeMessage(rest_);
  if (!decoded) {
    left_ = 0;
    rest_ = {};
    return decoded.error();
  }
  raw_ = rest_.first(decoded->size);
  rest_ = rest_.subspan(decoded->size);
  --left_;
  return decoded->message;
}

ByteBuffer PacketOf(const WireMessage& message) {
  ByteBuffer packet(kPacketHeaderSize);
  AppendMessage(message, packet);
  EncodePacketHeader({packet.size(), 1}, packet.data());
  return packet;
}

}  // namespace limpet
