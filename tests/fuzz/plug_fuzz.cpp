// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "limpet/mission/plug.hpp"
#include "tests/fuzz/time_bound.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using Undefined = limpet::PlugOptions::Undefined;
  const limpet::TimeBound bound(size);
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const Undefined undefined :
       {Undefined::kKeepLine, Undefined::kKeepMacro, Undefined::kRefuse}) {
    limpet::PlugOptions options;
    options.macros = {{.name = "A", .value = "$(B)"},
                      {.name = "B", .value = ""},
                      {.name = "E", .value = "", .is_set_empty = true}};
    options.undefined = undefined;
    try {
      static_cast<void>(limpet::ExpandPlugs(text, "fuzz.moos", options));
    } catch (const limpet::ConfigError&) {
      continue;  // a refusal is a fine answer
    }
  }
  return 0;
}
