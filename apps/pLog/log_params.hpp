// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/core/params.hpp"

namespace limpet {

/// pLogger's block, with its names.
struct LogParams {
  bool async_log = true;
  std::string sync_log = "false";
  bool wildcard_logging = true;
  std::vector<std::string> wildcard_patterns{"*"};
  std::vector<std::string> wildcard_omit_patterns;
  bool has_exclusion_log = false;
  std::vector<std::string> logged;
  bool has_aux = true;
  bool marks_data_type = false;
  bool marks_communities = false;
  std::string logs_binaries = "live";
  int double_precision = 5;
  int spare_columns = 0;
  std::string path;
  std::string file = "limpet";
  bool has_time_stamp = true;
  bool uses_utc = false;
  bool compresses = false;
  std::string summary_file = "./.LastOpenedMOOSLogDirectory";

  template <class Visitor>
  void Describe(Visitor& visit) {
    visit("AsyncLog", async_log, "Write the .alog file");
    visit("SyncLog", sync_log, "`true @ seconds`: write the .slog table of the `Log` variables");
    visit("WildCardLogging", wildcard_logging, "Log every variable that matches a pattern");
    visit("WildCardPattern", wildcard_patterns, "Variables to log, comma-separated; `*` and `?`");
    visit("WildCardOmitPattern", wildcard_omit_patterns, "Variables not to log; `*` and `?`");
    visit("WildCardExclusionLog", has_exclusion_log, "What patterns leave out goes to an .xlog");
    visit("Log", logged, "`VARIABLE @ seconds [,NOSYNC] [,MONITOR]`: at most that often");
    visit("LogAuxSrc", has_aux, "Write `app:aux` for the source");
    visit("MarkDataType", marks_data_type, "Begin values with D: or S:");
    visit("MarkExternalCommunityMessages", marks_communities,
          "Append @community to foreign sources");
    visit("LogBinary", logs_binaries,
          "Log binary variables too, to a .blog file; `live`: in a community only");
    visit("DoublePrecision", double_precision, "Decimals of numbers", InRange(0, 17));
    visit("DynamicSyncLogColumns", spare_columns, "Columns of the .slog that LOG_REQUEST may name",
          InRange(0, 255));
    visit("Path", path, "Parent folder in a community, unless the global GlobalLogPath is set");
    visit("File", file, "Stem of the log in a community; embedded runs name it by the session");
    visit("FileTimeStamp", has_time_stamp, "Append date and time to the stem");
    visit("UTCLogDirectories", uses_utc, "Date and time of the stem in UTC, not local");
    visit("CompressAlogs", compresses, "Turn .alog and .xlog into .gz when they are closed");
    visit("LoggingDirectorySummaryFile", summary_file, "Where a community's last folder is noted");
  }
};

}  // namespace limpet
