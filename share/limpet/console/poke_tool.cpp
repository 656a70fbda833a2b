// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "limpet/console/community.hpp"
#include "limpet/console/exit_code.hpp"
#include "limpet/console/poke.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/console/tool_frame.hpp"
#include "limpet/console/tools.hpp"

namespace limpet {
namespace {

Command PokeForm(const std::string& caller) {
  return {.name = caller,
          .words = "[mission.moos] VAR=value [VAR:=string ...]",
          .about = R"(Writes variables into a community, reads them back, and prints what they were
and are.

  VAR=3       a number if it looks like one, else a string
  VAR:=3      the string, as it stands
  VAR="3"     the string between the quotes (guard them from the shell)
  @MOOSTIME   as the value, or inside one: the community's time; so is @UTC)",
          .options = WithAddressOptions(
              {{.names = "-q,--quiet", .meaning = "print only what goes wrong"}}),
          .more = fmt::format(R"(host=NAME and port=N, as uPokeDB takes them, are understood too.

Exit code 1 if the broker does not answer or refuses a value: a variable keeps the type of its
first write.

  {0} missions/table1 DEPLOY=true
  {0} --port 9001 SPEED=1.5 LABEL:=007)",
                              caller)};
}

struct PokeCommand {
  CommunityAddress address;
  std::vector<std::string> words;
  bool is_quiet = false;
};

/// `host=x` and its kin, as MOOS spells them, as options.
std::vector<std::string> WithMoosSpellings(std::span<const std::string> args) {
  constexpr std::array<std::array<std::string_view, 2>, 7> kSpellings{{{"host", "--host="},
                                                                       {"server", "--host="},
                                                                       {"serverhost", "--host="},
                                                                       {"server_host", "--host="},
                                                                       {"port", "--port="},
                                                                       {"serverport", "--port="},
                                                                       {"server_port", "--port="}}};
  std::vector<std::string> words(args.begin(), args.end());
  for (std::string& word : words) {
    for (const auto& [name, option] : kSpellings) {
      const std::size_t equals = word.find('=');
      if (equals != std::string::npos && EqualsIgnoringCase(word.substr(0, equals), name)) {
        word = std::string(option) + word.substr(equals + 1);
        break;
      }
    }
  }
  return words;
}

PokeCommand ReadPoke(const Arguments& given) {
  PokeCommand command;
  std::vector<std::string> others;
  for (const std::string& word : given.positionals()) {
    const bool is_poke = word.find('=') != std::string::npos;
    (is_poke ? command.words : others).push_back(word);
  }
  const ToolWords sorted = Sorted(others);
  if (!sorted.others.empty()) {
    throw UsageError(fmt::format("`{}` is neither VAR=value nor a mission file",
                                 OneLine(sorted.others.front(), 60)));
  }
  if (command.words.empty()) {
    throw UsageError("nothing to write; VAR=value is expected");
  }
  command.address = AddressOf(
      given, sorted.missions.empty() ? std::nullopt : std::optional(sorted.missions.front()));
  command.is_quiet = given.Has("quiet");
  return command;
}

std::vector<Poke> PokesOf(const std::vector<std::string>& words, Seconds now) {
  std::vector<Poke> pokes;
  for (const std::string& word : words) {
    Expected<Poke> poke = ParsePoke(word, now);
    if (!poke) {
      throw UsageError(poke.error().text);
    }
    pokes.push_back(*std::move(poke));
  }
  return pokes;
}

std::string ShownMessage(const std::optional<Message>& message, bool keeps_utf8) {
  if (!message) {
    return "-";
  }
  const KeptValue value = KeptValue::Of(message->value);
  return fmt::format("{} {}", value.type, ShownValue(value, 60, keeps_utf8));
}

void PrintResults(const std::vector<PokeResult>& results, Seconds now) {
  const bool keeps_utf8 = TerminalReadsUtf8();
  TextTable table({"VARIABLE", "BEFORE", "WRITTEN BY", "AGE", "AFTER"});
  for (const PokeResult& result : results) {
    const bool is_written = result.outcome == PokeResult::Outcome::kWritten;
    table.Add({{OneLine(result.poke.name, 60, keeps_utf8)},
               {ShownMessage(result.before, keeps_utf8)},
               {result.before ? OneLine(result.before->source, 24, keeps_utf8) : "-"},
               {result.before ? ShownAge(now - result.before->time) : "-"},
               {is_written ? ShownMessage(result.after, keeps_utf8) : "refused",
                is_written ? Ink::kGood : Ink::kBad}});
  }
  PrintFrame(table.Lines());
}

std::vector<Message> SettledOrThrow(Community& community, const PokeCommand& command,
                                    const std::string& otherwise) {
  const std::optional<std::vector<Mail>> mail = community.Settle();
  if (!mail) {
    throw std::runtime_error(fmt::format("{} did not answer within {:g} s; {}",
                                         command.address.Text(), command.address.patience.value(),
                                         otherwise));
  }
  std::vector<Message> messages;
  for (const Mail& piece : *mail) {
    messages.push_back(piece.message);
  }
  return messages;
}

int WritePokes(const std::string& caller, const PokeCommand& command) {
  static_cast<void>(PokesOf(command.words, Seconds(0.0)));  // complain before anybody is called
  Community community(command.address, OwnName("uPoke"));
  const std::vector<Poke> pokes = PokesOf(command.words, community.Now());
  for (const Poke& poke : pokes) {
    community.client().Subscribe(poke.name, Seconds(0.0));
  }
  const auto before = SettledOrThrow(community, command, "nothing was written");
  const Seconds now = community.Now();
  for (const Poke& poke : pokes) {
    community.client().PublishValue(poke.name, poke.value);
  }
  const auto after = SettledOrThrow(community, command, "it is not known what was written");
  const auto results = PokeResults(pokes, community.name(), before, after);
  if (!command.is_quiet) {
    PrintResults(results, now);
  }
  int code = kOk;
  for (const PokeResult& result : results) {
    if (result.outcome == PokeResult::Outcome::kRefused) {
      fmt::print(stderr, "{}: {}\n", caller, WhyRefused(result));
      code = kFailed;
    }
  }
  return code;
}

}  // namespace

int RunPoke(const std::string& caller, std::span<const std::string> args) {
  return RunTool(PokeForm(caller), WithMoosSpellings(args),
                 [&](const Arguments& given) { return WritePokes(caller, ReadPoke(given)); });
}

}  // namespace limpet
