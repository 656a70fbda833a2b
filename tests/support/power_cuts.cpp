// SPDX-License-Identifier: MIT
#include "tests/support/power_cuts.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>

#include <fmt/format.h>

#include "limpet/durable/durable_file.hpp"
#include "limpet/durable/journal_format.hpp"
#include "limpet/durable/synced_append.hpp"
#include "limpet/logbook/gzip_file.hpp"
#include "limpet/session/session_store.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/torn_disk.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

/// Lives of up to this long a time are cut at each of their calls alike.
class CutLife {
 public:
  explicit CutLife(std::uint64_t seed) : random_(seed, "power cuts"), disk_(Made(root())) {}

  [[nodiscard]] fs::path root() const { return folder_.path() / "disk"; }
  [[nodiscard]] TornDisk& disk() { return disk_; }
  [[nodiscard]] Random& random() { return random_; }
  [[nodiscard]] std::string Text(std::size_t longest) {
    std::string text(random_.Index(longest) + 1, ' ');
    for (char& c : text) {
      c = static_cast<char>('a' + random_.Index(26));
    }
    return text;
  }

  using Judge = std::function<std::string(std::size_t calls, const fs::path& left, bool& has_lost)>;
  /// Cuts it, and has what is left judged: a complaint, or nothing.
  [[nodiscard]] PowerCuts Cut(int cuts, const Judge& judge) {
    PowerCuts result;
    const fs::path left = folder_.path() / "left";
    for (; result.cuts < cuts; ++result.cuts) {
      const std::size_t calls = random_.Index(disk_.calls() + 1);
      disk_.Cut(calls, random_, left);
      bool has_lost = false;
      const std::string complaint = judge(calls, left, has_lost);
      result.lossy += has_lost ? 1 : 0;
      if (!complaint.empty()) {
        result.complaints.push_back(fmt::format("cut {} after call {} of {}: {}", result.cuts,
                                                calls, disk_.calls(), complaint));
      }
    }
    return result;
  }

 private:
  static fs::path Made(const fs::path& folder) {
    fs::create_directories(folder);
    return folder;
  }

  TemporaryFolder folder_{PlaceInMemory()};
  Random random_;
  TornDisk disk_;
};

/// What the disk has been asked when something was done with.
struct Mark {
  std::size_t calls = 0;
  std::size_t done = 0;
};

std::size_t DoneBefore(const std::vector<Mark>& marks, std::size_t calls) {
  std::size_t done = 0;
  for (const Mark& mark : marks) {
    if (mark.calls <= calls) done = mark.done;
  }
  return done;
}

}  // namespace

PowerCuts CutWholeFile(std::uint64_t seed, int cuts) {
  CutLife life(seed);
  std::vector<std::string> versions{""};
  std::vector<Mark> marks;
  const fs::path folder = "a/b";
  for (int i = 0; i < 6; ++i) {
    versions.push_back(life.Text(3000));
    if (CreateFolders(life.root() / folder, life.disk()) ||
        WriteDurably(life.root() / folder / "x", versions.back(), life.disk())) {
      return {.cuts = 0, .lossy = 0, .complaints = {"cannot be written"}};
    }
    marks.push_back({life.disk().calls(), versions.size() - 1});
  }
  return life.Cut(cuts, [&](std::size_t calls, const fs::path& left, bool& has_lost) {
    const std::size_t done = DoneBefore(marks, calls);
    const Expected<std::string> text = ReadWhole(left / folder / "x");
    const auto found = std::find(versions.begin(), versions.end(), text ? *text : "");
    has_lost = !text || *text != versions.back();
    const bool is_recent = found - versions.begin() >= static_cast<std::ptrdiff_t>(done);
    return found != versions.end() && is_recent ? std::string()
                                                : fmt::format("version {} is gone", done);
  });
}

PowerCuts CutJournal(std::uint64_t seed, int cuts) {
  CutLife life(seed);
  SyncedAppend::Time now{};
  std::vector<std::string> records;
  std::vector<Mark> marks;
  std::vector<std::pair<SyncedAppend::Time, std::size_t>> put;  // when, how many by then
  Expected<AppendFile> created = AppendFile::Create(life.root() / "x", life.disk());
  SyncedAppend file(*std::move(created), SyncTimer::kInterval, now);
  std::string bytes(kJournalHeader);
  std::uint64_t chain = 0;
  for (int i = 0; i < 60; ++i) {
    for (std::size_t j = life.random().Index(3); j > 0; --j) {
      records.push_back(life.Text(life.random().Chance(0.1) ? 5000 : 100));
      AppendJournalRecord(bytes, chain, records.back());
    }
    put.emplace_back(now, records.size());
    if (!file.Write(bytes, now)) {
      return {.cuts = 0, .lossy = 0, .complaints = {"cannot be written"}};
    }
    bytes.clear();
    marks.push_back({life.disk().calls(), static_cast<std::size_t>(i)});
    now += milliseconds(20 + life.random().Index(230));
  }
  return life.Cut(cuts, [&](std::size_t calls, const fs::path& left, bool& has_lost) {
    const SyncedAppend::Time at = put[DoneBefore(marks, calls)].first;
    std::size_t wanted = 0;
    for (const auto& [when, count] : put) {
      if (at - when >= milliseconds(1000)) wanted = count;
    }
    std::ifstream in(left / "x", std::ios::binary);
    std::error_code missing;
    const std::uintmax_t size = fs::file_size(left / "x", missing);
    JournalReader reader(in, missing ? 0 : size);
    std::size_t found = 0;
    for (std::string payload; reader.Next(payload); ++found) {
      if (found >= records.size() || payload != records[found]) {
        return fmt::format("record {} is none of its", found);
      }
    }
    has_lost = found < records.size();
    return found >= wanted ? std::string() : fmt::format("{} records, not {}", found, wanted);
  });
}

namespace {

/// Generations of which some tiles of the map are as before.
class SavedGenerations {
 public:
  explicit SavedGenerations(CutLife& life) : life_(life) {}

  [[nodiscard]] bool Commit(SessionWriter& writer, bool has_former) {
    SessionFiles written{{"objects.json", life_.Text(500)}, {"mission/a.moos", life_.Text(200)}};
    std::set<std::string> unchanged;
    SessionFiles all = written;
    for (const char* tile : {"map/-1_0.ot.gz", "map/0_0.ot.gz", "map/0_1.ot.gz", "map/1_1.ot.gz"}) {
      const auto former = saved_.back().find(tile);
      if (has_former && former != saved_.back().end() && life_.random().Chance(0.7)) {
        unchanged.insert(tile);
        all.insert(*former);
      } else if (life_.random().Chance(0.8)) {
        all[tile] = written[tile] = life_.Text(8000);
      }
    }
    saved_.push_back(std::move(all));
    const bool is_saved = writer.Commit({}, written, unchanged).has_value();
    marks_.push_back({life_.disk().calls(), saved_.size() - 1});
    return is_saved;
  }
  [[nodiscard]] const std::vector<SessionFiles>& saved() const { return saved_; }
  [[nodiscard]] const std::vector<Mark>& marks() const { return marks_; }

 private:
  CutLife& life_;
  std::vector<SessionFiles> saved_{{}};
  std::vector<Mark> marks_;
};

}  // namespace

PowerCuts CutSession(std::uint64_t seed, int cuts) {
  CutLife life(seed);
  const fs::path home = fs::path("run") / "session";
  SavedGenerations generations(life);
  const auto commit = [&](SessionWriter& writer, bool has_former) {
    return generations.Commit(writer, has_former);
  };
  SessionWriter first(life.root() / home, life.disk()), second(life.root() / home, life.disk());
  SessionWriter of_next_life(life.root() / home, life.disk());
  const bool is_done = commit(first, false) && commit(first, true) && commit(first, true) &&
                       SetSessionAside(life.root() / home, life.disk()) && commit(second, false) &&
                       commit(second, true) && commit(of_next_life, true);
  if (!is_done) {
    return {.cuts = 0, .lossy = 0, .complaints = {"cannot be saved"}};
  }
  const std::vector<SessionFiles>& saved = generations.saved();
  return life.Cut(cuts, [&](std::size_t calls, const fs::path& left, bool& has_lost) {
    const std::size_t wanted = DoneBefore(generations.marks(), calls);
    std::size_t found = 0;
    std::string trouble = "none";
    for (const char* name : {"session", "session-former-1"}) {
      const Expected<StoredSession> session = LoadSession(left / "run" / name);
      if (!session) {
        if (fs::exists(left / "run" / name / "manifest.json")) trouble = session.error().text;
        continue;
      }
      const auto same = std::find(saved.begin(), saved.end(), session->files);
      if (same == saved.end()) return std::string("a session that nobody saved");
      found = std::max(found, static_cast<std::size_t>(same - saved.begin()));
    }
    has_lost = found + 1 < saved.size();
    return found >= wanted && trouble == "none"
               ? std::string()
               : fmt::format("generation {} where {} was saved; {}", found, wanted, trouble);
  });
}

PowerCuts CutPackedLog(std::uint64_t seed, int cuts) {
  CutLife life(seed);
  const std::string text = life.Text(60'000);
  const auto read = [](const fs::path& file) {
    std::string all;
    if (Expected<SequentialFile> in = SequentialFile::Open(file)) {
      std::string block(70'000, '\0');
      for (std::size_t count = 0; (count = in->Read(block.data(), block.size())) > 0;) {
        all.append(block, 0, count);
      }
    }
    return all;
  };
  const fs::path file = life.root() / "x.alog";
  if (WriteDurably(file, text, life.disk()) || !CompressFile(file, life.disk())) {
    return {.cuts = 0, .lossy = 0, .complaints = {"cannot be packed"}};
  }
  const std::size_t written = 5;  // open, write, sync, rename, sync the folder
  return life.Cut(cuts, [&](std::size_t calls, const fs::path& left, bool& has_lost) {
    const bool is_plain = read(left / "x.alog") == text;
    const bool is_packed = read(left / "x.alog.gz") == text;
    has_lost = !is_packed;
    return calls < written || is_plain || is_packed ? std::string() : "neither is whole";
  });
}

}  // namespace limpet
