// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "limpet/app/run_app.hpp"
#include "limpet/console/community.hpp"
#include "limpet/console/exit_code.hpp"
#include "limpet/console/scope_screen.hpp"
#include "limpet/console/terminal.hpp"
#include "limpet/console/tool_frame.hpp"
#include "limpet/console/tools.hpp"
#include "limpet/core/clock.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/wire/message_id.hpp"

namespace limpet {
namespace {

Command ScopeForm(const std::string& caller) {
  return {.name = caller,
          .words = "[mission.moos] [PATTERN ...]",
          .about = R"(Shows the variables of a community, live: value, type, writer, age, rate.
PATTERN chooses them (`*`: anything, `?`: one character); without one all are shown. Ages and rates
are in MOOS seconds, that is, of the mission's clock whatever the time warp.

Piped, it prints one line per write instead: MOOS time, variable, writer, type, value.)",
          .options = WithAddressOptions(
              {{.names = "--source",
                .value = "PATTERN",
                .meaning = "only variables last written by such an app",
                .is_repeatable = true},
               {.names = "--sort",
                .value = "ORDER",
                .meaning = "name, age, rate or source",
                .fallback = "name",
                .rule = OneOf({"name", "age", "rate", "source"})},
               {.names = "--changed",
                .meaning = "only variables whose value has changed since they were first heard"},
               {.names = "--history",
                .value = "VAR",
                .meaning = "begin with the history of VAR; piped: VAR alone"},
               {.names = "--once", .meaning = "print the table once and end"},
               {.names = "--rate",
                .value = "N",
                .meaning = "pictures a second",
                .fallback = "4",
                .rule = NumberBetween(0.1, 30.0, "pictures a second")}}),
          .more = fmt::format(
              R"(Keys: q quit, s sort, r reverse, / filter, c changed only, space pause, arrows and
page keys move, h or Enter history of the variable under the cursor, Esc back. NO_COLOR=1 leaves
out colours.

  {0} missions/table1 'NAV_*' 'DB_*' --source pNav
  {0} --port 9001 NAV_DEPTH | head)",
              caller)};
}

struct ScopeCommand {
  CommunityAddress address;
  std::vector<std::string> patterns;
  ScopeScreen::Settings settings;
  Seconds period{0.25};
  bool is_once = false;
};

ScopeSort SortOf(const std::string& text) {
  for (const ScopeSort sort :
       {ScopeSort::kName, ScopeSort::kAge, ScopeSort::kRate, ScopeSort::kSource}) {
    if (text == NameOf(sort)) {
      return sort;
    }
  }
  return ScopeSort::kName;
}

ScopeCommand ReadScope(const Arguments& given) {
  const ToolWords words = Sorted(given.positionals());
  ScopeCommand command;
  command.address = AddressOf(
      given, words.missions.empty() ? std::nullopt : std::optional(words.missions.front()));
  command.patterns = words.others;
  command.settings.filter.sources = given.All("source");
  command.settings.filter.changed_only = given.Has("changed");
  command.settings.sort = SortOf(*given.Find("sort"));
  command.settings.history_of = given.Find("history").value_or("");
  command.is_once = given.Has("once");
  command.period = Seconds(1.0 / *given.Number("rate"));
  return command;
}

/// A community's mail, turned into a table.
class ScopeFeed {
 public:
  explicit ScopeFeed(ScopeCommand command)
      : command_(std::move(command)), community_(command_.address, OwnName("uScope")) {
    std::vector<std::string>& names = command_.settings.filter.names;
    names = command_.patterns;
    const std::string& history = command_.settings.history_of;
    if (!history.empty() && (!names.empty() || ::isatty(STDOUT_FILENO) == 0)) {
      names.push_back(history);
    }
    for (const std::string& name : names.empty() ? std::vector<std::string>{"*"} : names) {
      community_.Watch(name);
    }
  }

  /// Hears mail; what of it passes the filter is handed to `show`.
  template <class Show>
  void Hear(const std::vector<Mail>& mail, Show show) {
    for (const auto& [message, heard] : mail) {
      if (message.id == message_id::kAnswer) {
        continue;  // an answer, no variable
      }
      table_.Hear(message, heard);
      const VariableRow& row = *table_.Find(message.name);
      if (command_.settings.filter.Accepts(row)) {
        show(row);
      }
    }
  }
  [[nodiscard]] ScopeScene Scene() {
    const TcpClient& client = community_.client();
    const bool is_connected = client.state() == TcpClient::State::kConnected;
    const std::string trouble = client.trouble();
    return {.moment = {.now = client.Now(), .warp = client.warp(), .keeps_utf8 = keeps_utf8_},
            .community = client.community(),
            .place = command_.address.Text(),
            .trouble = is_connected      ? ""
                       : trouble.empty() ? "connecting"
                                         : trouble,
            .lost = community_.lost()};
  }
  [[nodiscard]] Community& community() { return community_; }
  [[nodiscard]] const ScopeCommand& command() const { return command_; }
  [[nodiscard]] VariableTable& table() { return table_; }

 private:
  ScopeCommand command_;
  Community community_;
  VariableTable table_;
  bool keeps_utf8_ = TerminalReadsUtf8();
};

int RunLive(ScopeFeed& feed) {
  struct Frozen {
    VariableTable table;
    ScopeScene scene;
  };
  ScopeScreen screen(feed.command().settings);
  Terminal terminal;
  std::optional<Frozen> frozen;
  Seconds next = SteadyTime();
  while (!EndIsRequested() && !screen.wants_to_quit() && terminal.is_open()) {
    feed.Hear(feed.community().TakeMail(), [](const VariableRow&) {});
    if (screen.is_paused() && !frozen) {
      frozen = {feed.table(), feed.Scene()};
    } else if (!screen.is_paused()) {
      frozen.reset();
    }
    const ScreenSize size = terminal.Size();
    terminal.Show(frozen ? screen.Draw(frozen->table, frozen->scene, size)
                         : screen.Draw(feed.table(), feed.Scene(), size));
    next = std::max(next + feed.command().period, SteadyTime());
    for (const Key& key : terminal.ReadKeys(next - SteadyTime())) {
      screen.Press(key);
    }
  }
  return kOk;
}

/// `1767225600.123 NAV_X pNav D 12.5`
std::string StreamLine(const VariableRow& row, bool keeps_utf8) {
  const auto word = [keeps_utf8](const std::string& text) {
    return text.empty() ? std::string("-") : OneLine(text, kAnyWidth, keeps_utf8);
  };
  return fmt::format("{:.3f} {} {} {} {}\n", row.written.value(), word(row.name), word(row.source),
                     row.value.type, ShownValue(row.value, kAnyWidth, keeps_utf8));
}

int RunStream(ScopeFeed& feed) {
  constexpr Seconds kSlice(0.2);
  std::string told;
  while (!EndIsRequested()) {
    std::string lines;
    feed.Hear(feed.community().TakeMail(kSlice), [&](const VariableRow& row) {
      lines += StreamLine(row, feed.Scene().moment.keeps_utf8);
    });
    if (std::fwrite(lines.data(), 1, lines.size(), stdout) != lines.size() ||
        std::fflush(stdout) != 0) {
      return kFailed;
    }
    const std::string trouble = feed.Scene().trouble;
    if (!trouble.empty() && trouble != told) {
      fmt::print(stderr, "no connection to {} ({}); trying again\n", feed.Scene().place,
                 OneLine(trouble));
    }
    told = trouble;
  }
  return kOk;
}

/// Takes write rates out of the table that a broker keeps in DB_VARSUMMARY: `NAME ... 4.0 Hz ...`.
void HearRates(std::string_view summary, VariableTable& table) {
  for (const std::string& line : Split(summary, '\n')) {
    const std::size_t unit = line.find(" Hz");
    const std::size_t number = line.substr(0, unit).rfind(' ');
    if (unit == std::string::npos || number == std::string::npos) {
      continue;
    }
    if (const auto hz = ParseNumber(line.substr(number, unit - number))) {
      table.HearRate(line.substr(0, line.find(' ')), *hz);
    }
  }
}

std::size_t PrintedWidth() {
  winsize size{};
  const bool is_terminal = ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return is_terminal ? size.ws_col : kAnyWidth;
}

int RunOnce(ScopeFeed& feed) {
  feed.community().Watch("DB_VARSUMMARY");
  const auto mail = feed.community().Settle();
  if (!mail) {
    throw std::runtime_error(fmt::format("{} does not answer", feed.command().address.Text()));
  }
  feed.Hear(*mail, [](const VariableRow&) {});
  for (const Mail& piece : *mail) {
    if (const auto* text = std::get_if<std::string>(&piece.message.value);
        text != nullptr && piece.message.name == "DB_VARSUMMARY") {
      HearRates(*text, feed.table());
    }
  }
  const ScopeMoment moment = feed.Scene().moment;
  const ScopeScreen::Settings& settings = feed.command().settings;
  const auto rows = Arranged(feed.table(), settings.filter, settings.sort, false, moment.now);
  const ScopeColumns columns(rows, PrintedWidth(), moment.keeps_utf8);
  Frame frame{columns.Head()};
  for (const VariableRow* row : rows) {
    frame.push_back(columns.Row(*row, moment));
  }
  PrintFrame(frame);
  if (rows.empty()) {
    fmt::print(stderr, "no variable matches\n");
  }
  return rows.empty() ? kFailed : kOk;
}

}  // namespace

int RunScope(const std::string& caller, std::span<const std::string> args) {
  return RunTool(ScopeForm(caller), args, [](const Arguments& given) {
    ScopeFeed feed(ReadScope(given));
    if (feed.command().is_once) {
      return RunOnce(feed);
    }
    return Terminal::IsThere() ? RunLive(feed) : RunStream(feed);
  });
}

}  // namespace limpet
