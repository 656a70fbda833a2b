// SPDX-License-Identifier: MIT
#include "limpet/wire/message_codec.hpp"

#include <bit>
#include <cstring>

#include <fmt/format.h>

#include "limpet/core/require.hpp"
#include "limpet/wire/little_endian.hpp"

namespace limpet {
namespace {

std::byte* PutText(std::byte* out, std::string_view text) {
  out = Put(out, static_cast<std::int32_t>(text.size()));
  if (!text.empty()) {
    std::memcpy(out, text.data(), text.size());
  }
  return out + text.size();
}

/// Reads fields one after the other and stays inside the message whatever its lengths say.
class FieldReader {
 public:
  explicit FieldReader(ByteView bytes) : bytes_(bytes) {}

  template <class T>
  [[nodiscard]] T Number() {
    T value{};
    if (Has(sizeof(T))) {
      value = Get<T>(bytes_.data() + at_);
      at_ += sizeof(T);
    }
    return value;
  }
  [[nodiscard]] std::string_view Text() {
    const auto size = Number<std::int32_t>();
    if (size < 0 || !Has(static_cast<std::size_t>(size))) {
      is_good_ = false;
      return {};
    }
    const auto* begin = reinterpret_cast<const char*>(bytes_.data() + at_);
    at_ += static_cast<std::size_t>(size);
    return {begin, static_cast<std::size_t>(size)};
  }
  [[nodiscard]] bool is_good() const { return is_good_; }
  [[nodiscard]] bool is_at_end() const { return at_ == bytes_.size(); }

 private:
  [[nodiscard]] bool Has(std::size_t count) {
    is_good_ = is_good_ && count <= bytes_.size() - at_;
    return is_good_;
  }

  ByteView bytes_;
  std::size_t at_ = 0;
  bool is_good_ = true;
};

}  // namespace

std::size_t EncodedSize(const WireMessage& message) {
  return kMessageFixedSize + message.source.size() + message.source_aux.size() +
         message.community.size() + message.key.size() + message.text.size();
}

void EncodeMessage(const WireMessage& message, std::byte* out) {
  const std::size_t size = EncodedSize(message);
  LIMPET_REQUIRE(size <= INT32_MAX, "a message beyond 2 GiB");
  out = Put(out, static_cast<std::int32_t>(size));
  out = Put(out, message.id);
  out = Put(out, message.type);
  out = Put(out, message.data_type);
  out = PutText(out, message.source);
  out = PutText(out, message.source_aux);
  out = PutText(out, message.community);
  out = PutText(out, message.key);
  out = Put(out, message.time);
  out = Put(out, message.number);
  out = Put(out, message.number2);
  PutText(out, message.text);
}

void AppendMessage(const WireMessage& message, ByteBuffer& out) {
  const std::size_t begin = out.size();
  out.resize(begin + EncodedSize(message));
  EncodeMessage(message, out.data() + begin);
}

Expected<DecodedMessage> DecodeMessage(ByteView bytes) {
  if (bytes.size() < kMessageFixedSize) {
    return Error{fmt::format("{} bytes are too few for a message", bytes.size())};
  }
  const auto size = Get<std::int32_t>(bytes.data());
  if (size < static_cast<std::int32_t>(kMessageFixedSize) ||
      static_cast<std::size_t>(size) > bytes.size()) {
    return Error{fmt::format("message of {} bytes in {}", size, bytes.size())};
  }
  FieldReader read(bytes.first(static_cast<std::size_t>(size)).subspan(sizeof(std::int32_t)));
  WireMessage message;
  message.id = read.Number<std::int32_t>();
  message.type = read.Number<char>();
  message.data_type = read.Number<char>();
  message.source = read.Text();
  message.source_aux = read.Text();
  message.community = read.Text();
  message.key = read.Text();
  message.time = read.Number<double>();
  message.number = read.Number<double>();
  message.number2 = read.Number<double>();
  message.text = read.Text();
  if (!read.is_good() || !read.is_at_end()) {
    return Error{fmt::format("the strings of a message of {} bytes do not fit it", size)};
  }
  return DecodedMessage{message, static_cast<std::size_t>(size)};
}

}  // namespace limpet
