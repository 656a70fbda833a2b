// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "limpet/core/message.hpp"
#include "limpet/logbook/alog_reader.hpp"

namespace limpet {

/// Which entries of a log are played.
struct PlayChoice {
  std::vector<std::string> only{};  ///< patterns; none: all but the database's own variables
  std::vector<std::string> skip{};
  std::optional<double> from{};  ///< seconds since the start of the log, both included
  std::optional<double> to{};
  bool begins_with_held = true;  ///< `from` set: what held then comes first

  [[nodiscard]] bool AcceptsName(std::string_view name) const;
  [[nodiscard]] bool Accepts(const AlogEntry& entry) const;
};

/// A variable's last entry before playing starts; it owns its words.
struct HeldEntry {
  std::uint64_t order = 0;  ///< in the log
  std::string source{}, aux{}, value{};
  std::optional<double> number{};
};

/// What a first look through a log tells about the entries chosen.
struct LogOutline {
  /// Variables with a value that is no number: all their values are strings, since a variable keeps
  /// the type it had.
  std::set<std::string, std::less<>> texts{};
  std::uint64_t entries = 0;
  double start = 0.0;  ///< log time at which playing starts: of the first entry, never before 0
  double end = 0.0;    ///< latest log time
  /// What held when playing starts, by name; as far back as the log goes.
  std::map<std::string, HeldEntry, std::less<>> held{};

  [[nodiscard]] static LogOutline Of(AlogReader& reader, const PlayChoice& choice);
};

/// Hands out a log's messages when they are due, first what held when playing starts, then in the
/// log's order: an entry that was logged late comes right behind the one before it. Knows no clock.
class LogPlayer {
 public:
  static constexpr double kWholeLog = std::numeric_limits<double>::infinity();

  /// `folder` holds the .blog file of the log's binary values.
  LogPlayer(AlogReader reader, PlayChoice choice, LogOutline outline, std::filesystem::path folder);
  ~LogPlayer() = default;
  LogPlayer(const LogPlayer&) = delete;  // the next entry's views lie in the reader
  LogPlayer& operator=(const LogPlayer&) = delete;

  /// The next message if it is due within `elapsed` seconds of log since the start. It has no time
  /// and no community. Nothing: wait, or it is the end.
  [[nodiscard]] std::optional<Message> Next(double elapsed);
  [[nodiscard]] bool is_at_end() const { return !entry_ && held_.empty(); }
  /// When the next message is due, in seconds of log since the start. REQUIRES: !is_at_end().
  [[nodiscard]] double next_due() const { return held_.empty() ? due_ : 0.0; }
  [[nodiscard]] const LogOutline& outline() const { return outline_; }
  [[nodiscard]] std::uint64_t played() const { return played_; }
  /// Binary values whose bytes the .blog file does not hold; they are left out.
  [[nodiscard]] std::uint64_t unreadable() const { return unreadable_; }

 private:
  void Advance();
  [[nodiscard]] std::optional<Message> NextHeld();
  [[nodiscard]] std::optional<Message> MessageOf(const AlogEntry& entry) const;

  AlogReader reader_;
  PlayChoice choice_;
  LogOutline outline_;
  std::filesystem::path folder_;
  std::vector<std::string> held_;   ///< names still to be handed out, the next one last
  std::optional<AlogEntry> entry_;  ///< the next one; its views last until the reader's next call
  double due_ = 0.0;
  std::uint64_t played_ = 0;
  std::uint64_t unreadable_ = 0;
};

}  // namespace limpet
