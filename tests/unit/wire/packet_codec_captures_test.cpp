// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "limpet/wire/packet_codec.hpp"
#include "tests/support/moos_captures.hpp"

namespace limpet {
namespace {

/// Decodes packet by packet and encodes anew.
ByteBuffer Recoded(ByteView bytes, std::string& trouble) {
  ByteBuffer out;
  while (!bytes.empty() && trouble.empty()) {
    const auto header = bytes.size() >= kPacketHeaderSize
                            ? DecodePacketHeader(bytes)
                            : Expected<PacketHeader>(Error{"half a header"});
    if (!header || header->size > bytes.size()) {
      trouble = header ? "half a packet" : header.error().text;
      break;
    }
    const std::size_t begin = out.size();
    out.resize(begin + kPacketHeaderSize);
    PacketReader reader(bytes.first(header->size));
    while (!reader.is_at_end()) {
      const auto message = reader.Next();
      if (!message) {
        trouble = message.error().text;
        break;
      }
      AppendMessage(*message, out);
    }
    EncodePacketHeader({out.size() - begin, header->count}, out.data() + begin);
    bytes = bytes.subspan(header->size);
  }
  return out;
}

TEST(Captures, RecordedSessionsComeBackByteForByte) {
  const auto servers = Captures(".server.bin");
  const auto clients = Captures(".client.bin");
  ASSERT_FALSE(servers.empty());
  for (const auto& file : servers) {
    const ByteBuffer bytes = BytesOfFile(file);
    std::string trouble;
    EXPECT_EQ(Recoded(bytes, trouble), bytes) << file << ": " << trouble;
  }
  for (const auto& file : clients) {
    const ByteBuffer bytes = BytesOfFile(file);
    if (bytes.size() <= kGreeting.size()) {
      continue;  // a greeting alone
    }
    EXPECT_TRUE(IsGreeting(bytes)) << file;
    const ByteView packets = ByteView(bytes).subspan(kGreeting.size());
    std::string trouble;
    EXPECT_EQ(Recoded(packets, trouble), ByteBuffer(packets.begin(), packets.end()))
        << file << ": " << trouble;
  }
}

TEST(Captures, RecordedDatagramsComeBackByteForByte) {
  const auto datagrams = Captures(".datagram.bin");
  ASSERT_FALSE(datagrams.empty());
  for (const auto& file : datagrams) {
    const ByteBuffer bytes = BytesOfFile(file);
    const auto decoded = DecodeMessage(bytes);
    ASSERT_TRUE(decoded.has_value()) << file << ": " << decoded.error().text;
    ByteBuffer out;
    AppendMessage(decoded->message, out);
    EXPECT_EQ(out, bytes) << file;
  }
}

}  // namespace
}  // namespace limpet
