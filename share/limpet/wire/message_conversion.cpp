// SPDX-License-Identifier: MIT
#include "limpet/wire/message_conversion.hpp"

namespace limpet {
namespace {

Value ValueFrom(const WireMessage& message) {
  if (message.data_type == wire_data::kDouble) {
    return message.number;
  }
  if (message.data_type == wire_data::kBinary) {
    const auto* bytes = reinterpret_cast<const std::byte*>(message.text.data());
    return Binary(bytes, bytes + message.text.size());
  }
  return std::string(message.text);
}

}  // namespace

Message MessageFrom(const WireMessage& message) {
  return {.name = std::string(message.key),
          .value = ValueFrom(message),
          .time = Seconds(message.time),
          .source = std::string(message.source),
          .source_aux = std::string(message.source_aux),
          .community = std::string(message.community),
          .id = message.id};
}

WireMessage ViewOf(const Message& message) {
  WireMessage view{.id = message.id,
                   .source = message.source,
                   .source_aux = message.source_aux,
                   .community = message.community,
                   .key = message.name,
                   .time = message.time.value()};
  if (const auto* number = std::get_if<double>(&message.value)) {
    view.number = *number;
  } else if (const auto* text = std::get_if<std::string>(&message.value)) {
    view.data_type = wire_data::kString;
    view.text = *text;
  } else {
    const auto& bytes = std::get<Binary>(message.value);
    view.data_type = wire_data::kBinary;
    view.text = {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  return view;
}

}  // namespace limpet
