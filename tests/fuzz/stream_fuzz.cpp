// SPDX-License-Identifier: MIT
// meta.csv, a line of dashes, stream.csv; what is understood goes through the estimator.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "estimation/replay/replay.hpp"
#include "limpet/core/config.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kRows = 300;  // a fuzzer's patience
  limpet::StreamFile meta{.name = "meta.csv", .lines = {}, .damage = {}};
  limpet::StreamFile rows{.name = "stream.csv", .lines = {}, .damage = {}};
  bool is_meta = true;
  for (std::string& line :
       limpet::Split(std::string_view(reinterpret_cast<const char*>(data), size), '\n')) {
    if (is_meta && line == "---") {
      is_meta = false;
    } else {
      (is_meta ? meta : rows).lines.push_back(std::move(line));
    }
  }
  const auto stream = limpet::ParseSensorStream(meta, rows);
  if (!stream || stream->rows.size() > kRows) {
    return 0;
  }
  const auto result = limpet::Replay(
      *stream, limpet::ParamsForStream(stream->meta), [] { return 0.0; }, {}, {},
      limpet::SensorsForStream(stream->meta));
  for (const limpet::SmoothedPose& pose : result.online) {
    if (!std::isfinite(pose.t)) std::abort();
  }
  return 0;
}
