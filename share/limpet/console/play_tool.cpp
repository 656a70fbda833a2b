// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include <fmt/format.h>

#include "limpet/app/run_app.hpp"
#include "limpet/console/community.hpp"
#include "limpet/console/exit_code.hpp"
#include "limpet/console/log_player.hpp"
#include "limpet/console/progress_line.hpp"
#include "limpet/console/tool_frame.hpp"
#include "limpet/console/tools.hpp"
#include "limpet/core/clock.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/wire/message_conversion.hpp"

namespace limpet {
namespace {

ValueRule SpeedRule() {
  return {.allowed = "a number above 0, or max", .accepts = [](const std::string& text) {
            const std::optional<double> speed = ParseNumber(text);
            return text == "max" || (speed && *speed > 0.0);
          }};
}

Command PlayForm(const std::string& caller) {
  const ValueRule seconds = AnyNumber("seconds since the start of the log");
  return {
      .name = caller,
      .words = "<log.alog> [mission.moos]",
      .about =
          "Plays a log, ours or MOOS's, also as .gz, into a community: in the log's "
          "order, with the log's pauses, each message under the name of the app that "
          "wrote it, with the time at which it is played. Binary values come from the "
          ".blog file beside the log. The database's own DB_* are left out.",
      .options = WithAddressOptions(
          {{.names = "--speed",
            .value = "N|max",
            .meaning = "seconds of log per second of the community's clock",
            .fallback = "1",
            .rule = SpeedRule()},
           {.names = "--from",
            .value = "S",
            .meaning = "only entries from then on, in seconds since the start of the log; "
                       "first the value that every variable had then",
            .rule = seconds},
           {.names = "--to", .value = "S", .meaning = "only entries up to then", .rule = seconds},
           {.names = "--bare", .meaning = "with --from: without the values of before"},
           {.names = "--only",
            .value = "PATTERN",
            .meaning = "only such variables",
            .is_repeatable = true},
           {.names = "--skip", .value = "PATTERN", .meaning = "not these", .is_repeatable = true},
           {.names = "--as",
            .value = "NAME",
            .meaning = "join as NAME and write everything under it; the app goes into the "
                       "aux"}}),
      .more = "Exit code 1 if it was stopped or the community was lost.\n\n  " + caller +
              " run.alog --port 9001 --speed 10 --only 'NAV_*'"};
}

constexpr Seconds kPlaySlice(0.05);                         ///< real time
constexpr std::size_t kMostUnsent = std::size_t{4} << 20U;  // [bytes]

struct PlayCommand {
  CommunityAddress address;
  std::filesystem::path log;
  PlayChoice choice;
  double speed = 1.0;
  bool plays_at_once = false;  ///< --speed max
  std::string alias;
};

/// A folder holds one log, or it is not said which.
std::filesystem::path LogOf(const std::string& word) {
  if (!std::filesystem::is_directory(word)) {
    return word;
  }
  std::vector<std::filesystem::path> logs;
  for (const auto& entry : std::filesystem::directory_iterator(word)) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(".alog") || name.ends_with(".alog.gz")) {
      logs.push_back(entry.path());
    }
  }
  if (logs.size() != 1) {
    throw UsageError(fmt::format("{} holds {} logs; name one", word, logs.size()));
  }
  return logs.front();
}

PlayCommand ReadPlay(const Arguments& given) {
  const ToolWords words = Sorted(given.positionals());
  if (words.others.size() != 1) {
    throw UsageError("one log is expected, e.g. run.alog");
  }
  PlayCommand command;
  command.address = AddressOf(
      given, words.missions.empty() ? std::nullopt : std::optional(words.missions.front()));
  command.log = LogOf(words.others.front());
  command.choice = {.only = given.All("only"),
                    .skip = given.All("skip"),
                    .from = given.Number("from"),
                    .to = given.Number("to"),
                    .begins_with_held = !given.Has("bare")};
  if (command.choice.from && command.choice.to && *command.choice.from > *command.choice.to) {
    throw UsageError("--from lies behind --to");
  }
  command.plays_at_once = *given.Find("speed") == "max";
  command.speed = given.Number("speed").value_or(1.0);
  command.alias = given.Find("as").value_or("");
  return command;
}

AlogReader OpenLog(const std::filesystem::path& log) {
  Expected<AlogReader> reader = AlogReader::Open(log);
  if (!reader) {
    throw std::runtime_error(fmt::format("{} cannot be read", log.string()));
  }
  return *std::move(reader);
}

LogOutline OutlineOf(const PlayCommand& command) {
  AlogReader reader = OpenLog(command.log);
  LogOutline outline = LogOutline::Of(reader, command.choice);
  if (outline.entries == 0) {
    throw std::runtime_error(fmt::format("{} holds no entry to play", command.log.string()));
  }
  return outline;
}

class Playback {
 public:
  explicit Playback(const PlayCommand& command)
      : command_(command),
        player_(OpenLog(command.log), command.choice, OutlineOf(command),
                command.log.parent_path()),
        community_(command.address, command.alias.empty() ? OwnName("uPlay") : command.alias),
        progress_(command.log.filename().string()) {}

  int Run() {
    start_ = heard_ = SteadyTime();
    while (!player_.is_at_end() && !EndIsRequested()) {
      const double until = Elapsed();
      SendDue(until);
      CheckConnection();
      ShowProgress(std::min(until, Length()));
      Wait();
    }
    const bool is_complete = player_.is_at_end();
    if (is_complete) {
      ShowProgress(Length());
    }
    Drain();
    Report(is_complete);
    return is_complete ? kOk : kFailed;
  }

 private:
  [[nodiscard]] double Length() const { return player_.outline().end - player_.outline().start; }
  /// Seconds of log per second of real time.
  [[nodiscard]] double Pace() { return command_.speed * community_.client().warp(); }
  [[nodiscard]] double Elapsed() {
    return command_.plays_at_once ? LogPlayer::kWholeLog : (SteadyTime() - start_).value() * Pace();
  }
  [[nodiscard]] bool HasRoom() { return community_.client().unsent() < kMostUnsent; }

  void SendDue(double until) {
    constexpr int kBetweenLooks = 64;
    for (int count = 1; count % kBetweenLooks != 0 || (HasRoom() && !EndIsRequested()); ++count) {
      std::optional<Message> message = player_.Next(until);
      if (!message) {
        return;
      }
      message->time = community_.Now();
      position_ = player_.is_at_end() ? Length() : player_.next_due();
      if (!command_.alias.empty()) {
        message->source_aux =
            message->source + (message->source_aux.empty() ? "" : ":" + message->source_aux);
        message->source = community_.name();
      }
      community_.client().Send(ViewOf(*message));
    }
  }

  void CheckConnection() {
    const Seconds now = SteadyTime();
    if (community_.client().state() == TcpClient::State::kConnected) {
      heard_ = now;
    } else if (now - heard_ > command_.address.patience) {
      throw std::runtime_error(fmt::format("lost the community at {} ({}) after {} messages",
                                           command_.address.Text(), community_.client().trouble(),
                                           player_.played()));
    }
  }

  void ShowProgress(double elapsed) {
    const double at = command_.plays_at_once ? position_ : elapsed;
    const double done = Length() > 0.0 ? std::clamp(at / Length(), 0.0, 1.0) : 0.0;
    progress_.Update(
        done, fmt::format("{:.1f} of {:.1f} s, {} messages", at, Length(), player_.played()));
  }

  void Wait() {
    if (player_.is_at_end()) {
      return;
    }
    double wait = HasRoom() ? kPlaySlice.value() : 1e-3;
    if (!command_.plays_at_once) {
      wait = std::min(wait, (player_.next_due() - Elapsed()) / Pace());
    } else if (HasRoom()) {
      wait = 0.0;
    }
    if (wait > 0.0) {
      std::this_thread::sleep_for(std::chrono::duration<double>(wait));
    }
  }

  /// Waits until the broker has had all of it.
  void Drain() {
    const Seconds deadline = SteadyTime() + command_.address.patience;
    while (community_.client().unsent() > 0 && SteadyTime() < deadline) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (!EndIsRequested() && !community_.Settle()) {
      throw std::runtime_error(
          fmt::format("{} does not confirm what was played", command_.address.Text()));
    }
  }

  void Report(bool is_complete) {
    fmt::print("{}{} messages, {:.1f} s of log in {:.1f} s\n",
               is_complete ? "played " : "stopped after ", player_.played(),
               std::min(position_, Length()), (SteadyTime() - start_).value());
    if (player_.unreadable() > 0) {
      fmt::print(stderr, "{} binary values are not in the .blog file beside the log\n",
                 player_.unreadable());
    }
  }

  PlayCommand command_;
  LogPlayer player_;
  Community community_;
  ProgressLine progress_;
  Seconds start_, heard_;
  double position_ = 0.0;  ///< seconds of log played
};

}  // namespace

int RunPlay(const std::string& caller, std::span<const std::string> args) {
  return RunTool(PlayForm(caller), args,
                 [](const Arguments& given) { return Playback(ReadPlay(given)).Run(); });
}

}  // namespace limpet
