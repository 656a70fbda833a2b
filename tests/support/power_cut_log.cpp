// SPDX-License-Identifier: MIT
#include <chrono>
#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "limpet/core/number_text.hpp"
#include "limpet/durable/sync_timer.hpp"
#include "limpet/logbook/alog_reader.hpp"
#include "limpet/logbook/log_files.hpp"
#include "limpet/logbook/log_folder.hpp"
#include "tests/support/power_cuts.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/torn_disk.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;
using Time = SyncTimer::Clock::time_point;

constexpr Seconds kLogStart{1767225600.0};
const fs::path kLogFile = fs::path("logs") / "L" / "L.alog";

Value ValueOf(int number, Random& random) {
  if (random.Chance(0.2)) {
    return Binary(random.Index(3000), static_cast<std::byte>(number));
  }
  return std::string(random.Index(random.Chance(0.1) ? 4000 : 60) + 1,
                     static_cast<char>('a' + number % 26));
}

/// A logger's life, on a clock of its own.
class LoggedLife {
 public:
  LoggedLife(std::uint64_t seed, const fs::path& root)
      : disk_(root), random_(seed, "a logger's life") {
    const auto folder = CreateLogFolder(root / "logs", "L", disk_);
    Open(*folder, false);
    for (int number = 0; number < 60; ++number) {
      Put(number);
      if (timer_.IsDue(now_)) Sync();
      marks_.push_back({disk_.calls(), now_});
      if (random_.Chance(0.03)) Open(*folder, true);
      now_ += milliseconds(10 + random_.Index(190));
    }
    Sync();
    marks_.push_back({disk_.calls(), now_});
  }

  [[nodiscard]] const TornDisk& disk() const { return disk_; }
  [[nodiscard]] Random& random() { return random_; }
  /// Complaint about what a cut after `calls` has left in `folder`.
  [[nodiscard]] std::string Judge(std::size_t calls, const fs::path& folder, bool& has_lost) const;

 private:
  struct Mark {
    std::size_t calls = 0;
    Time time;
  };
  struct Written {
    Value value;
    Time time;
  };
  void Open(const fs::path& folder, bool continues) {
    files_.reset();
    files_ = *LogFiles::Open(folder, "L", kLogStart,
                             {.lines = {},
                              .has_excluded = true,
                              .has_system = true,
                              .sync = SlogWriter::Columns{.names = {"NAV_X"}, .spare = 1},
                              .continues = continues,
                              .disk = &disk_});
  }
  void Put(int number) {
    written_.push_back({ValueOf(number, random_), now_});
    const auto message = std::make_shared<const Message>(
        Message{.name = fmt::format("N{}", number),
                .value = written_.back().value,
                .time = kLogStart + Seconds(static_cast<double>(number)),
                .source = "test",
                .source_aux = "",
                .community = ""});
    files_->Put(LogLine{LogLine::File::kAsync, message});
    files_->Put(LogLine{LogLine::File::kSystem, message});
    files_->Put(SyncRow{.time = static_cast<double>(number), .values = {1.0}});
    files_->Flush();
    timer_.NoteWrite();
  }
  void Sync() {
    files_->Sync();
    timer_.NoteSync(now_);
  }
  [[nodiscard]] Time TimeOf(std::size_t calls) const {
    for (const Mark& mark : marks_) {
      if (mark.calls >= calls) return mark.time;
    }
    return now_;
  }

  TornDisk disk_;
  Random random_;
  Time now_{};
  SyncTimer timer_{SyncTimer::kInterval, now_};
  std::optional<LogFiles> files_;
  std::vector<Written> written_;
  std::vector<Mark> marks_;
};

/// Numbers of the messages in a log that are there with the values that were written.
template <class Written>
std::vector<bool> FoundIn(const fs::path& file, const std::vector<Written>& written) {
  std::vector<bool> found(written.size(), false);
  Expected<AlogReader> reader = AlogReader::Open(file);
  if (!reader) return found;
  for (AlogEntry entry; reader->Next(entry);) {
    const std::optional<double> number =
        entry.name.starts_with('N') ? ParseNumber(entry.name.substr(1)) : std::nullopt;
    if (!number || *number < 0.0 || *number >= static_cast<double>(written.size())) continue;
    const auto index = static_cast<std::size_t>(*number);
    Value value = std::string(entry.value);
    if (const auto span = ParseBlogMarker(entry.value)) {
      const Expected<Binary> bytes = ReadBlog(file.parent_path(), *span);
      if (!bytes) continue;
      value = *bytes;
    }
    found[index] = found[index] || value == written[index].value;
  }
  return found;
}

std::string LoggedLife::Judge(std::size_t calls, const fs::path& folder, bool& has_lost) const {
  const Time cut = TimeOf(calls);
  const fs::path file = folder / kLogFile;
  for (const char* stage : {"after the cut", "gone on with"}) {
    const std::vector<bool> found = FoundIn(file, written_);
    for (std::size_t i = 0; i < written_.size(); ++i) {
      has_lost = has_lost || !found[i];
      if (cut - written_[i].time >= milliseconds(1000) && !found[i]) {
        return fmt::format("{}: message {} is gone", stage, i);
      }
    }
    if (!fs::exists(file.parent_path())) break;
    // The next life opens what is left, and writes behind it.
    if (!LogFiles::Open(file.parent_path(), "L", kLogStart, {.lines = {}, .continues = true})) {
      return "cannot be gone on with";
    }
  }
  return {};
}

}  // namespace

PowerCuts CutLog(std::uint64_t seed, int cuts) {
  const TemporaryFolder folder(PlaceInMemory());
  fs::create_directories(folder.path() / "disk");
  LoggedLife life(seed, folder.path() / "disk");
  PowerCuts result;
  for (; result.cuts < cuts; ++result.cuts) {
    const std::size_t calls = life.random().Index(life.disk().calls() + 1);
    life.disk().Cut(calls, life.random(), folder.path() / "left");
    bool has_lost = false;
    const std::string complaint = life.Judge(calls, folder.path() / "left", has_lost);
    result.lossy += has_lost ? 1 : 0;
    if (!complaint.empty()) {
      result.complaints.push_back(
          fmt::format("cut {} after call {}: {}", result.cuts, calls, complaint));
    }
  }
  return result;
}

}  // namespace limpet
