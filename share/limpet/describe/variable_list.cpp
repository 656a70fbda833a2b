// SPDX-License-Identifier: MIT
#include "limpet/describe/variable_list.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "limpet/app/registry.hpp"
#include "limpet/describe/markdown_cell.hpp"
#include "limpet/mission/mission_file.hpp"
#include "limpet/runs/session_runner.hpp"
#include "limpet/topics/wall_clock.hpp"  // no app includes it: LimpetDB is none

namespace limpet {
namespace {

/// Keeps what an app subscribes to; carries no mail.
class SubscriptionRecorder final : public AppLink {
 public:
  SubscriptionRecorder(std::string app, Readers& readers)
      : app_(std::move(app)), readers_(&readers) {}
  void Publish(std::string, Value, std::string) override {}
  void Subscribe(const std::string& name, Seconds) override { (*readers_)[name].insert(app_); }
  void SubscribeWildcard(const WildcardFilter& filter) override {
    (*readers_)[filter.variable_pattern].insert(app_);
  }
  [[nodiscard]] Seconds Now() const override { return Seconds(0.0); }

 private:
  std::string app_;
  Readers* readers_;
};

std::set<std::string> ReadersOfVariable(const Readers& readers, const std::string& name) {
  const auto found = readers.find(name);
  return found == readers.end() ? std::set<std::string>{} : found->second;
}

std::string TypeOf(const Variable& variable) {
  return variable.fields.empty()
             ? variable.type
             : fmt::format("{}: {}", variable.type, fmt::join(variable.fields, ", "));
}

}  // namespace

Readers ReadersOf(const std::filesystem::path& mission_folder) {
  const MissionFile mission = LoadMission(mission_folder / "mission.moos");
  Readers readers;
  for (const std::string& name : EmbeddedApps(mission)) {
    const auto entry = AppRegistry().find(name);
    if (entry == AppRegistry().end()) {
      throw ConfigError(
          {{.file = mission.file, .line = 0}, "Run", fmt::format("no app `{}`", name)});
    }
    SubscriptionRecorder link(name, readers);
    const AppContext context{.name = name,
                             .link = &link,
                             .globals = mission.globals,
                             .mission_folder = mission_folder,
                             .run_folder = {},
                             .prior_folder = {},
                             .session = "discovery",
                             .seed = 1};
    const ConfigBlock* block = mission.Block(name);
    const ConfigBlock defaults{.name = name, .where = {}, .entries = {}};
    static_cast<void>(entry->second.create(context, block != nullptr ? *block : defaults));
  }
  return readers;
}

std::string PlainText(const Variable& variable, const Readers& readers) {
  const auto line = [](const char* label, const std::string& text) {
    return text.empty() ? std::string() : fmt::format("  {:<8} {}\n", label, text);
  };
  const TopicFacts& facts = variable.facts;
  return fmt::format("{}: {}\n", variable.name, variable.meaning) + line("type", TypeOf(variable)) +
         line("unit", facts.unit) + line("frame", facts.frame) + line("rate", facts.rate) +
         line("writers", fmt::format("{}", fmt::join(facts.writers, ", "))) +
         line("readers",
              fmt::format("{}", fmt::join(ReadersOfVariable(readers, variable.name), ", ")));
}

std::string Json(const std::vector<Variable>& variables, const Readers& readers) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Variable& variable : variables) {
    list.push_back({{"name", variable.name},
                    {"meaning", variable.meaning},
                    {"type", variable.type},
                    {"fields", variable.fields},
                    {"unit", variable.facts.unit},
                    {"frame", variable.facts.frame},
                    {"rate", variable.facts.rate},
                    {"writers", variable.facts.writers},
                    {"readers", ReadersOfVariable(readers, variable.name)}});
  }
  return list.dump(1) + "\n";
}

std::string Markdown(const std::vector<Variable>& variables, const Readers& readers) {
  std::string page =
      "# Variables\n\nEvery variable that apps exchange, from its declaration in "
      "`share/limpet/topics`; readers are what the apps of `missions/table1` subscribe to. Apps "
      "that hear everything: ";
  page += fmt::format("{}. `operator` is a person, or a flag of the mission.\n\n",
                      fmt::join(ReadersOfVariable(readers, "*"), ", "));
  page +=
      "Generated: `limpet describe variables missions/table1 --markdown > docs/variables.md`. "
      "Beside "
      "these, every app raises its warnings as `<APP>_WARNINGS` ([warnings](warnings.md)), and a "
      "`.bhv` file may name variables of its own in flags and conditions.\n\n"
      "| variable | meaning | type | unit | frame | rate | writers | readers |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const Variable& variable : variables) {
    const TopicFacts& facts = variable.facts;
    page += fmt::format("| `{}` | {} | {} | {} | {} | {} | {} | {} |\n", variable.name,
                        MarkdownCell(variable.meaning), MarkdownCell(TypeOf(variable)), facts.unit,
                        facts.frame, facts.rate, fmt::join(facts.writers, ", "),
                        fmt::join(ReadersOfVariable(readers, variable.name), ", "));
  }
  return page;
}

}  // namespace limpet
