// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/durable/append_file.hpp"
#include "limpet/logbook/alog_format.hpp"
#include "limpet/logbook/log_buffer.hpp"

namespace limpet {

/// Writes MOOS's .slog: a table with one row per period and one column per variable, 18 wide, NaN
/// where there is no fresh number. The names stand in the banner and again every 30 rows. Spare
/// columns can be given a name later, which is then written over their place in the banner.
class SlogWriter {
 public:
  struct Columns {
    std::vector<std::string> names;  ///< the time's column comes before them
    int spare = 0;
  };
  [[nodiscard]] static Expected<SlogWriter> Open(const std::filesystem::path& file, Seconds start,
                                                 const Columns& columns, const AlogOptions& options,
                                                 FileSystem& disk = RealFileSystem());

  /// `time` in seconds since the start. Missing values are NaN; those beyond the columns are
  /// dropped.
  void WriteRow(double time, const std::vector<double>& values);
  /// Names the next spare column; false if there is none.
  bool Claim(const std::string& name);
  bool Flush() { return lines_.Flush(); }
  bool Sync() { return lines_.Sync(); }
  [[nodiscard]] std::error_code trouble() const { return lines_.trouble(); }
  [[nodiscard]] const LogLosses& losses() const { return lines_.losses(); }

 private:
  SlogWriter(AppendFile file, int decimals) : lines_(std::move(file)), decimals_(decimals) {}
  void WriteHeader(const std::string& banner, const Columns& columns);
  void WriteLabels();

  LogBuffer lines_;
  int decimals_;
  std::vector<std::string> names_;
  std::vector<std::uint64_t> spare_places_;  ///< in the file, of names not yet given
  int rows_ = 0;
};

}  // namespace limpet
