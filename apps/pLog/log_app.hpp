// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/pLog/log_choice.hpp"
#include "apps/pLog/log_memory.hpp"
#include "apps/pLog/log_params.hpp"
#include "apps/pLog/log_session.hpp"
#include "limpet/app/app.hpp"
#include "limpet/logbook/sync_table.hpp"
#include "limpet/topics/safety.hpp"

namespace limpet {

/// Writes what it hears to a log, in order of arrival. Embedded, the file is <session>.alog in the
/// run folder, its banner holds virtual time alone, and it is written by the one thread there is,
/// so that equal runs give equal bytes. In a community it is <Path>/<stem>/<stem>.alog and its kin,
/// written by a thread of its own: a slow disk delays nobody, and a power cut costs less than a
/// second.
class LogApp final : public App {
 public:
  using Params = LogParams;

  LogApp(const AppContext& context, const Params& params);
  void Tick(Seconds now) override;
  void Report(ReportLines& report) const override;
  void Finish(Seconds now) override;

 private:
  void ReadParams();
  void SubscribeToAll();
  void OnMail(const MessagePtr& message);
  void OnCommand(const MessagePtr& message);
  void OnCopyRequest(std::string_view name, std::string_view asker);
  /// The file itself, behind all links, or why it must not be copied.
  [[nodiscard]] Expected<std::filesystem::path> CopyableFile(std::string_view name) const;
  void OnLogRequest(std::string_view line);
  void Restart();

  /// Opened by the first message, not at construction: a mission that fails to build leaves
  /// nothing.
  void OpenIfNeeded();
  [[nodiscard]] std::optional<Error> Open();
  /// Where LogMemory lies; empty if nobody would look for it.
  [[nodiscard]] std::filesystem::path MemoryFile() const;
  [[nodiscard]] Expected<std::filesystem::path> CreateFolder();
  [[nodiscard]] LogFilesOptions FileOptions() const;
  void AnnounceFolder(const std::filesystem::path& folder);
  void Put(LogRecord record);
  void PutDueRow();
  void Save();
  /// What became of the log; `why` it is not written, empty if it is.
  void TellState(const std::string& why);
  void WatchMonitored(Seconds now);
  [[nodiscard]] static std::string Joined(const std::vector<std::string>& patterns);

  Params params_;
  std::optional<LogMemory> former_;      ///< of a former life, to go on with
  std::optional<Seconds> logged_until_;  ///< what is older is in its log
  Seconds start_;
  bool logs_binaries_ = false;
  LogChoice choice_;
  std::map<std::string, Seconds, std::less<>> monitored_;  ///< variable to last time heard

  std::optional<Seconds> sync_period_;
  std::vector<std::string> sync_names_;  ///< columns of the .slog
  int spare_columns_ = 0;                ///< not yet named ones
  std::optional<SyncTable> table_;

  LogSession session_;
  std::optional<Seconds> failed_at_;  ///< when a log could not be opened
  std::string failure_;               ///< why
  std::uint64_t unlogged_ = 0;        ///< messages that came while none was open
  LogState told_;                     ///< as LOG_STATE
  std::optional<Seconds> told_at_;
  bool is_over_ = false;  ///< a community's last message was written
  std::string folder_;    ///< as announced
  Seconds last_announcement_;
  int copies_ = 0, refused_copies_ = 0;  ///< at COPY_FILE_REQUEST
  std::optional<Seconds> last_refusal_;
  std::int64_t messages_ = 0, binaries_ = 0;  ///< put into the log
};

}  // namespace limpet
