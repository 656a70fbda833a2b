// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/session.hpp"

#include <array>
#include <chrono>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/scratch_folder.hpp"
#include "limpet/app/cut_life.hpp"
#include "limpet/console/command_output.hpp"
#include "limpet/session/cut_session.hpp"
#include "limpet/session/saved_session.hpp"
#include "limpet/topics/mapping.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kApp = "pSession";
constexpr const char* kMapApp = "pMap";

Command RecoverForm() {
  return {.name = "limpet session recover",
          .words = "<session>",
          .about =
              "Brings a session that a power cut ended to its last second. It was saved a "
              "minute before, perhaps; what pSession and pMap heard since is in their journals "
              "(pSession.mail, pMap.mail), which this goes through, saves one more generation "
              "and removes. <session> is a session's run folder or the session folder in it. "
              "Exit code 3 if it is still under way.",
          .takes = "one session",
          .least_words = 1,
          .most_words = 1};
}

/// A pSession that lives notes its ticks, two a second.
bool IsUnderWay(const fs::path& journal) {
  constexpr std::chrono::milliseconds kSeveralTicks(2000);
  const auto size = fs::file_size(journal);
  std::this_thread::sleep_for(kSeveralTicks);
  return !fs::exists(journal) || fs::file_size(journal) != size;
}

fs::path MapJournalBeside(const fs::path& journal) { return journal.parent_path() / "pMap.mail"; }

/// As far as a session's own folders say; what was launched is in the session that it saved.
AppContext ContextOf(const fs::path& journal) {
  return {.name = kApp,
          .globals = {},
          .mission_folder = {},
          .run_folder = journal.parent_path(),
          .prior_folder = {},
          .session = fs::absolute(journal).parent_path().filename().string()};
}

/// Ends the life in a copy in `scratch`: however this ends, the journal is as it was.
CutLife EndLife(const AppContext& context, const ConfigBlock& block, const fs::path& journal,
                const ScratchFolder& scratch, std::span<const Message> last_mail = {}) {
  const fs::path copy = scratch.path() / journal.filename();
  fs::copy_file(journal, copy);
  constexpr bool kGoesOn = true;
  const MailJournal mail(copy, kGoesOn);
  if (!mail.is_good()) throw std::runtime_error(copy.string() + ": " + mail.trouble());
  return EndCutLife(AppRegistry().at(context.name), context, block, mail, last_mail);
}

/// What pMap, brought to its own last second, says when it is asked for the map. Nothing where it
/// has no journal, or flew with what is not known: the map stays as it was last saved then.
std::vector<Message> MapAtTheEnd(const fs::path& journal, const ScratchFolder& scratch) {
  if (!fs::exists(journal)) return {};
  try {
    const SavedSession saved = LoadSavedSession(journal.parent_path(), "the session");
    const std::optional<ConfigBlock> block = BlockOf(saved, kMapApp);
    if (!block) return {};
    const AppContext context{.name = kMapApp,
                             .globals = {},
                             .mission_folder = {},
                             .run_folder = {},
                             .prior_folder = {},
                             .session = saved.facts.session};
    const auto question = [](const std::string& name) {
      return Message{.name = name,
                     .value = std::string("recovered"),
                     .time = {},
                     .source = kApp,
                     .source_aux = "",
                     .community = ""};
    };
    // All of its tiles: whether those of before have come to be in pSession's journal nobody knows.
    const std::array questions{question(topics::kMapSnapshotRequest.name),
                               question(topics::kMapTilesRequest.name)};
    return EndLife(context, *block, journal, scratch, questions).last_words;
  } catch (const ConfigError& error) {
    fmt::print(stderr, "note: the map stays as it was last saved: {}\n", error.what());
    return {};
  }
}

CutLife Recover(const fs::path& journal) {
  const ScratchFolder scratch("limpet-recover");
  const std::vector<Message> map = MapAtTheEnd(MapJournalBeside(journal), scratch);
  return EndLife(ContextOf(journal), {.name = kApp, .where = {}, .entries = {}}, journal, scratch,
                 map);
}

std::optional<double> SavedUntil(const fs::path& folder) {
  const Expected<StoredSession> stored = LoadSession(folder);
  return stored ? std::optional(stored->facts.saved_at) : std::nullopt;
}

void Tell(const std::string& folder, const CutLife& life, std::optional<double> before) {
  const SavedSession session = LoadSavedSession(folder, "the session");
  fmt::print("{}: {} messages gone through", folder, life.messages);
  if (before) fmt::print(", {:.1f} s more than it had saved", life.end.value() - *before);
  fmt::print("; {} frames, {} objects\n", session.memory.frames.size(),
             session.memory.objects.opis.size());
}

int RecoverSession(const Arguments& given) {
  const std::string& folder = given.positionals()[0];
  const std::optional<fs::path> journal = JournalOf(folder);
  if (!journal) {
    static_cast<void>(LoadSavedSession(folder, "the session"));
    fmt::print("{}: ended orderly, nothing to recover\n", folder);
    return kOk;
  }
  if (IsUnderWay(*journal)) {
    throw Refusal(fmt::format("{}: is being written: end the mission first", journal->string()));
  }
  const std::optional<double> before = SavedUntil(journal->parent_path());
  const CutLife life = Recover(*journal);
  bool is_saved = life.messages > 0;
  if (!is_saved) fmt::print(stderr, "{}: holds nothing that is whole\n", journal->string());
  for (const auto& [id, warning] : life.warnings) {
    fmt::print(stderr, "{}: {}\n", id, warning.text);
    is_saved = is_saved && warning.severity != Severity::kAlarm;
  }
  if (!is_saved) return kFailed;
  fs::remove(*journal);
  fs::remove(MapJournalBeside(*journal));
  Tell(folder, life, before);
  return kOk;
}

}  // namespace

int RunSession(std::span<const std::string> args) {
  if (args.empty() || args[0] == "--help" || args[0] == "-h") {
    fmt::print(
        "usage: limpet session recover <session>\n\n"
        "  recover    brings a session that was cut short to its last second\n\n"
        "`limpet session recover --help` says more.\n");
    return args.empty() ? kUsage : kOk;
  }
  if (args[0] == "recover") return RunCommand(RecoverForm(), args.subspan(1), RecoverSession);
  throw UsageError(fmt::format("no command `session {}`; there is `session recover`", args[0]));
}

}  // namespace limpet
