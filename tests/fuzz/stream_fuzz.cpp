// SPDX-License-Identifier: MIT
// meta.csv, a line of dashes, stream.csv, and if it goes on, a line of dashes and sources.csv; what
// is understood goes through the estimator.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

#include "estimation/navigation/source_block.hpp"
#include "estimation/replay/clock_steps.hpp"
#include "estimation/replay/replay.hpp"
#include "limpet/core/config.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kRows = 300;  // a fuzzer's patience
  limpet::StreamFile meta{.name = "meta.csv", .lines = {}, .damage = {}};
  limpet::StreamFile rows{.name = "stream.csv", .lines = {}, .damage = {}};
  limpet::StreamFile further{.name = "sources.csv", .lines = {}, .damage = {}};
  limpet::StreamFile* const files[] = {&meta, &rows, &further};
  std::size_t file = 0;
  for (std::string& line :
       limpet::Split(std::string_view(reinterpret_cast<const char*>(data), size), '\n')) {
    if (file < 2 && line == "---") {
      ++file;
    } else {
      files[file]->lines.push_back(std::move(line));
    }
  }
  auto stream = limpet::ParseSensorStream(meta, rows);
  if (!stream || limpet::AddSourceRows(further, *stream)) return 0;
  if (stream->rows.size() + stream->source_rows.size() > kRows) return 0;
  limpet::TakeOutClockSteps("stream", *stream);
  limpet::ReplaySensors sensors = limpet::SensorsForStream(stream->meta);
  for (auto& [name, factory] : limpet::ParseSources("acoustic_fix, magnetic_heading"))
    sensors.sources.emplace_back(name, std::move(factory));
  const auto result = limpet::Replay(
      *stream, limpet::ParamsForStream(stream->meta), [] { return 0.0; }, {}, {}, sensors);
  for (const limpet::SmoothedPose& pose : result.online) {
    if (!std::isfinite(pose.t)) std::abort();
  }
  return 0;
}
