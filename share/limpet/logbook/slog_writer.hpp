// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/logbook/alog_format.hpp"
#include "limpet/logbook/append_file.hpp"

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
                                                 const Columns& columns,
                                                 const AlogOptions& options);

  /// `time` in seconds since the start. Missing values are NaN; those beyond the columns are
  /// dropped.
  void WriteRow(double time, const std::vector<double>& values);
  /// Names the next spare column; false if there is none.
  bool Claim(const std::string& name);
  bool Flush();
  bool Sync();

 private:
  SlogWriter(AppendFile file, int decimals) : file_(std::move(file)), decimals_(decimals) {}
  void WriteHeader(const std::string& banner, const Columns& columns);
  void WriteLabels();

  AppendFile file_;
  int decimals_;
  std::vector<std::string> names_;
  std::vector<std::uint64_t> spare_places_;  ///< in the file, of names not yet given
  std::string buffer_;
  int rows_ = 0;
  bool is_good_ = true;
};

}  // namespace limpet
