// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "limpet/app/app.hpp"
#include "limpet/core/params.hpp"
#include "limpet/logbook/alog_writer.hpp"

namespace limpet {

/// Writes every message it hears to an .alog file, in order of arrival. Embedded, the file is
/// <session>.alog in the run folder and its banner holds virtual time alone, so that equal runs
/// give equal bytes; in a community it is <Path>/<stem>/<stem>.alog. Flushed each tick; in a
/// community also brought to the disk, so that a power cut costs one tick.
class LogApp final : public App {
 public:
  struct Params {
    bool async_log = true;
    bool wildcard_logging = true;
    std::vector<std::string> wildcard_patterns{"*"};
    std::vector<std::string> wildcard_omit_patterns;
    std::vector<std::string> logged;
    bool has_aux = true;
    bool marks_data_type = false;
    bool marks_communities = false;
    bool logs_binaries = false;
    int double_precision = 5;
    std::string path;
    std::string file = "limpet";
    bool has_time_stamp = true;

    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("AsyncLog", async_log, "Write the .alog file");
      visit("WildCardLogging", wildcard_logging, "Log every variable that matches a pattern");
      visit("WildCardPattern", wildcard_patterns, "Variables to log, comma-separated; `*` and `?`");
      visit("WildCardOmitPattern", wildcard_omit_patterns, "Variables not to log; `*` and `?`");
      visit("Log", logged,
            "`VARIABLE [@ seconds]`: log it at most that often, whatever patterns say");
      visit("LogAuxSrc", has_aux, "Write `app:aux` for the source");
      visit("MarkDataType", marks_data_type, "Begin values with D: or S:");
      visit("MarkExternalCommunityMessages", marks_communities,
            "Append @community to foreign sources");
      visit("LogBinary", logs_binaries, "Log binary variables too, to a .blog file");
      visit("DoublePrecision", double_precision, "Decimals of numbers", InRange(0, 17));
      visit("Path", path, "Parent folder in a community; else the global GlobalLogPath");
      visit("File", file, "Stem of the log in a community; embedded runs name it by the session");
      visit("FileTimeStamp", has_time_stamp, "Append date and time (UTC) to the stem");
    }
  };

  LogApp(const AppContext& context, const Params& params);
  void Tick(Seconds now) override;
  void Finish(Seconds now) override;

 private:
  /// One `Log =` line.
  struct Rate {
    Seconds interval;
    std::optional<Seconds> last;
  };
  void ReadRates();
  void OnMail(const MessagePtr& message);
  [[nodiscard]] bool Wants(const Message& message);
  [[nodiscard]] std::filesystem::path FilePath() const;
  /// Opened by the first message, not at construction: a mission that fails to build leaves
  /// nothing.
  void OpenIfNeeded();
  void Save();

  Params params_;
  Seconds start_;
  std::map<std::string, Rate, std::less<>> rates_;
  std::map<std::string, bool, std::less<>> matches_;  ///< verdict of the patterns per variable
  std::optional<AlogWriter> writer_;
  bool has_failed_ = false;
};

}  // namespace limpet
