// SPDX-License-Identifier: MIT
// One plain datagram, and one line of pShare's configuration or of PSHARE_CMD: what is let in
// encodes to the same bytes.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "limpet/sharing/output_book.hpp"
#include "limpet/sharing/share_datagram.hpp"
#include "limpet/sharing/share_gate.hpp"

using namespace limpet;  // NOLINT(google-build-using-namespace): one function

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const ByteView bytes(reinterpret_cast<const std::byte*>(data), size);
  ShareGate gate(nullptr, {{"NAV_*", "?", "DEPLOY"}});
  static_cast<void>(gate.Admit(bytes, {}));
  if (const auto message = DecodeShare(bytes)) {
    const auto again = EncodeShare(*message);
    if (again && !std::ranges::equal(*again, bytes)) {
      std::abort();
    }
  }
  const std::string_view line(reinterpret_cast<const char*>(data), size);
  static_cast<void>(ParseShareCommand(line));
  static_cast<void>(ParseShareInput(line, {}));
  static_cast<void>(ShareKey::Parse(line));
  if (const auto outputs = ParseShareOutputs(line, {})) {
    OutputBook book;
    for (const ShareOutput& output : *outputs) {
      book.Add(output, Seconds(0.0));
    }
    const Message message{.name = "NAV_X",
                          .value = 1.0,
                          .time = {},
                          .source = "pNav",
                          .source_aux = {},
                          .community = {}};
    static_cast<void>(book.TakeDue(message, Seconds(1.0)));
    static_cast<void>(book.Summary(Seconds(2.0)));
  }
  return 0;
}
