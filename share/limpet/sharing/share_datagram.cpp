// SPDX-License-Identifier: MIT
#include "limpet/sharing/share_datagram.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limpet/wire/message_codec.hpp"

namespace limpet {
namespace {

constexpr std::size_t kLongestName = 1024;

bool IsName(std::string_view text) {
  return text.size() <= kLongestName && std::ranges::none_of(text, [](char letter) {
           return static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f;
         });
}

bool IsData(char type) {
  return type == wire_data::kDouble || type == wire_data::kString || type == wire_data::kBinary;
}

}  // namespace

Expected<ByteBuffer> EncodeShare(const WireMessage& message) {
  const std::size_t size = EncodedSize(message);
  if (size > kLargestShare) {
    return Error{fmt::format("{} bytes are too many for a datagram; at most {} are shared", size,
                             kLargestShare)};
  }
  ByteBuffer bytes(size);
  EncodeMessage(message, bytes.data());
  return bytes;
}

Expected<WireMessage> DecodeShare(ByteView datagram) {
  const auto decoded = DecodeMessage(datagram);
  if (!decoded) {
    return decoded.error();
  }
  const WireMessage& message = decoded->message;
  if (decoded->size != datagram.size()) {
    return Error{fmt::format("{} bytes behind the message", datagram.size() - decoded->size)};
  }
  if (message.type != wire_type::kNotify || !IsData(message.data_type)) {
    return Error{"no write of a variable"};
  }
  if (message.key.empty() || message.key.find(',') != std::string_view::npos ||
      !IsName(message.key) || !IsName(message.source) || !IsName(message.source_aux) ||
      !IsName(message.community)) {
    return Error{"a name that no variable, app or community has"};
  }
  if (!std::isfinite(message.time)) {
    return Error{"a time that is no number"};
  }
  return message;
}

}  // namespace limpet
