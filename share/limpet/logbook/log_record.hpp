// SPDX-License-Identifier: MIT
// What a logger hands to the files of its session.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "limpet/core/message.hpp"

namespace limpet {

/// A message for one of the files.
struct LogLine {
  enum class File {
    kAsync,     ///< .alog
    kExcluded,  ///< .xlog: what the patterns keep out of the .alog
    kSystem,    ///< .ylog: MOOS_DEBUG and MOOS_SYSTEM
  };
  File file = File::kAsync;
  MessagePtr message;
};

/// One row of the .slog.
struct SyncRow {
  double time = 0.0;           ///< seconds since the log's start
  std::vector<double> values;  ///< NaN: no fresh number
};

/// Names a spare column of the .slog.
struct ColumnClaim {
  std::string name;
};

/// A file to be kept beside the log; its extension gets a leading underscore.
struct FileCopy {
  std::filesystem::path source;
  std::string stem;  ///< of the copy; empty: that of `source`
};

/// A line for people in the .alog.
struct LogComment {
  std::string text;
};

using LogRecord = std::variant<LogLine, SyncRow, ColumnClaim, FileCopy, LogComment>;

/// About how much memory a waiting record holds, bytes.
[[nodiscard]] std::size_t SizeOf(const LogRecord& record);

}  // namespace limpet
