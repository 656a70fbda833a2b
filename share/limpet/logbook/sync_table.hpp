// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/core/message.hpp"
#include "limpet/core/units.hpp"
#include "limpet/logbook/log_record.hpp"

namespace limpet {

/// Gathers the rows of the .slog: at each period the last number of every column, or NaN if none
/// came since the row before.
class SyncTable {
 public:
  SyncTable(std::vector<std::string> names, Seconds period);

  void AddColumn(const std::string& name);
  void Update(const Message& message);
  /// The row that is due at `since_start`, stamped with its place on the grid of periods. Rows of a
  /// time nobody asked about are skipped.
  [[nodiscard]] std::optional<SyncRow> TakeDueRow(Seconds since_start);

 private:
  std::vector<std::string> names_;
  std::vector<double> fresh_;
  Seconds period_;
  std::int64_t last_row_ = 0;
};

/// `SyncLog = true @ 0.2`: the period, at least 0.1 s and 1 s if not given; nothing for false.
[[nodiscard]] Expected<std::optional<Seconds>> ParseSyncLog(std::string_view text);

}  // namespace limpet
