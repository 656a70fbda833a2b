// SPDX-License-Identifier: MIT
// Reports, requests for them, and shapes: text that other programs send.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "limpet/app/app_caster.hpp"
#include "limpet/shapes/shape.hpp"
#include "limpet/topics/viewer.hpp"

namespace {

/// What decodes must be the same text when it is sent on, and again.
template <class Decode, class Encode>
void RoundTrip(const std::string& text, Decode decode, Encode encode) {
  if (const auto value = decode(text)) {
    const std::string once = encode(*value);
    const auto again = decode(once);
    if (!again || encode(*again) != once) {
      std::abort();
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  limpet::AppCaster caster;
  caster.Configure({.process = "pNav", .node = "alpha"});
  caster.OnRequest(text, limpet::Seconds(1.0));
  static_cast<void>(caster.IsDue(limpet::Seconds(2.0)));
  RoundTrip(
      text, [](const std::string& t) { return limpet::DecodeAppCast(t); }, limpet::EncodeAppCast);
  for (const char* variable : {"VIEW_POINT", "VIEW_SEGLIST", "VIEW_CIRCLE", "VIEW_MARKER"}) {
    static_cast<void>(limpet::DecodeShape(variable, text));
  }
  static_cast<void>(limpet::TopicCodec<limpet::NodeReport>::Decode(text));
  return 0;
}
