// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <string>

#include "limpet/sweeps/task_batch.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (const auto batch = limpet::TaskBatch::FromText(text)) {
    static_cast<void>(limpet::TaskBatch::FromText(batch->Text()));
  }
  return 0;
}
