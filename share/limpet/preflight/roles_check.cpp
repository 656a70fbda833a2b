// SPDX-License-Identifier: MIT
// Apps that are not launched and that others need. Who hears what is known by building every app
// with a link that only notes what it subscribes to; who writes what, by the variables'
// declarations.
#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limpet/app/app.hpp"
#include "limpet/helm/behavior_host.hpp"
#include "limpet/preflight/checks.hpp"
#include "limpet/topics/variable.hpp"

namespace limpet::internal {
namespace {

using Names = std::set<std::string>;

class SubscriptionNotes final : public AppLink {
 public:
  void Publish(std::string, Value, std::string) override {}
  void Subscribe(const std::string& name, Seconds) override { heard.insert(name); }
  void SubscribeWildcard(const WildcardFilter&) override {}  // loggers and bridges need nothing
  [[nodiscard]] Seconds Now() const override { return Seconds(0.0); }

  Names heard;
};

/// What an app subscribes to; what it cannot be built with are problems.
Names HeardBy(const LaunchedApp& app, const MissionReading& reading,
              std::vector<ConfigProblem>& problems) {
  SubscriptionNotes link;
  const AppContext context{.name = app.process,
                           .link = &link,
                           .globals = reading.mission().globals,
                           .mission_folder = reading.folder(),
                           .run_folder = {},
                           .prior_folder = {},
                           .session = "discovery",
                           .seed = 1};
  try {
    const std::unique_ptr<App> made = app.entry->create(context, app.block);
    for (const std::string& name : made->dispensable())
      link.heard.erase(name);
  } catch (const ConfigError& error) {
    for (ConfigProblem problem : error.problems()) {
      if (problem.where.file.empty()) problem.where = app.block.where;
      problems.push_back(std::move(problem));
    }
  }
  return link.heard;
}

/// A stream that stops when nobody writes it, unlike an event that may never come. What the helm
/// tells of itself is for displays.
bool IsVital(const Variable& variable) {
  const std::string& rate = variable.facts.rate;
  return !rate.empty() && rate.front() >= '0' && rate.front() <= '9' &&
         !variable.name.starts_with("IVPHELM_");
}

/// Limpet's apps that may write a variable; nothing if a person or another program may too. The
/// launcher writes last words alone.
Names WritersOf(const Variable& variable) {
  Names writers;
  for (const std::string& writer : variable.facts.writers) {
    if (writer == "pLaunch") continue;
    if (!AppRegistry().contains(writer)) return {};
    writers.insert(writer);
  }
  return writers;
}

struct Lack {
  Names variables, readers;
};

/// By the apps that would write: what is missing, and to whom.
class Roles {
 public:
  explicit Roles(const MissionReading& reading) : reading_(reading) {}

  void Need(const std::string& reader, const std::string& name, bool is_condition) {
    const auto variable = VariableCatalog().find(name);
    if (variable == VariableCatalog().end()) return;
    const Names writers = WritersOf(variable->second);
    const bool is_written = std::ranges::any_of(
        writers, [this](const std::string& writer) { return reading_.Launches(writer); });
    if (writers.empty() || is_written) return;
    Lack& lack = (is_condition || IsVital(variable->second) ? vital_ : other_)[writers];
    lack.variables.insert(name);
    lack.readers.insert(reader);
  }

  void Tell(MissionProblems& found) const {
    const ConfigBlock* antler = reading_.mission().Block("ANTLER");
    const SourceLine where =
        antler != nullptr ? antler->where : SourceLine{.file = reading_.mission().file, .line = 0};
    // A stranger, or another community over pShare, may write what our app would.
    const bool may_come = !reading_.strangers().empty() || reading_.Launches("pShare");
    for (const auto& [writers, lack] : vital_) {
      if (may_come) {
        found.notes.push_back({where, "Run", TextOfOthers(lack)});
      } else {
        found.syntax.push_back({where, "Run", Text(writers, lack, "needed by")});
      }
    }
    for (const auto& [writers, lack] : other_) {
      if (!vital_.contains(writers)) {
        found.notes.push_back({where, "Run", Text(writers, lack, "heard by")});
      }
    }
  }

 private:
  static std::string Text(const Names& writers, const Lack& lack, const char* relation) {
    return fmt::format("{} is not launched: nobody writes {}, {} {}", fmt::join(writers, " or "),
                       fmt::join(lack.variables, ", "), relation, fmt::join(lack.readers, ", "));
  }

  /// Who may write what none of our apps does here; a logger only listens.
  [[nodiscard]] std::vector<std::string> Others() const {
    std::vector<std::string> others;
    for (const LaunchEntry& stranger : reading_.strangers()) {
      if (stranger.binary != "pLogger") others.push_back(stranger.binary);
    }
    if (reading_.Launches("pShare")) others.emplace_back("another community");
    return others;
  }
  [[nodiscard]] std::string TextOfOthers(const Lack& lack) const {
    constexpr std::size_t kMost = 3;  // more names say less
    std::vector<std::string> others = Others();
    if (others.empty()) others.emplace_back("a program that is not launched here");
    if (others.size() > kMost) {
      others.resize(kMost);
      others.emplace_back("another app");
    }
    return fmt::format("{} must come from {}: {} needs it", fmt::join(lack.variables, ", "),
                       fmt::join(others, " or "), fmt::join(lack.readers, ", "));
  }

  const MissionReading& reading_;
  std::map<Names, Lack> vital_, other_;
};

/// Variables that conditions and modes read: without them a behavior never runs.
Names ReadByConditions(const MissionReading& reading) {
  try {
    const BehaviorHost host(reading.behavior_files());
    const std::vector<std::string> variables = host.Variables();
    return {variables.begin(), variables.end()};
  } catch (const ConfigError&) {
    return {};  // said already
  }
}

/// Images that nobody looks for objects in.
void CheckImages(const MissionReading& reading, bool has_reader, MissionProblems& found) {
  const auto kind = reading.Find("uSimCamera", "camera");
  if (!kind || has_reader || !reading.strangers().empty()) return;
  const bool is_rendered =
      kind->text == "rendered" ||
      (kind->text == "scenario" && reading.scenario() && reading.scenario()->camera == "rendered");
  if (is_rendered) {
    found.syntax.push_back({kind->where, "Run",
                            "pDetect is not launched: uSimCamera renders images, and nobody finds "
                            "objects in them"});
  }
}

/// Says which variables of nobody's the app hears because its block names them: a sensor's under a
/// name of its own.
void NoteNamed(const LaunchedApp& app, const Names& heard, MissionProblems& found) {
  for (const ConfigEntry& entry : app.block.entries) {
    if (!heard.contains(entry.value) || VariableCatalog().contains(entry.value)) continue;
    found.notes.push_back({entry.where, entry.key,
                           fmt::format("no app that is launched here writes {}: it must come from "
                                       "a program that is started otherwise",
                                       entry.value)});
  }
}

}  // namespace

std::vector<ConfigProblem> CheckRoles(const MissionReading& reading, MissionProblems& found) {
  std::vector<ConfigProblem> problems;
  Roles roles(reading);
  bool has_image_reader = false;
  for (const LaunchedApp& app : reading.apps()) {
    if (app.process == "pShare") continue;  // hears what its routes say; building it needs keys
    if (!app.stands_for.empty()) continue;  // its mission has other writers, or no use for it
    const Names heard =
        HeardBy(app, reading, IsForStock(reading, app.process) ? found.refused_here : problems);
    if (reading.strangers().empty() && !reading.Launches("pShare")) NoteNamed(app, heard, found);
    has_image_reader = has_image_reader || heard.contains("CAMERA_FRAME");
    const Names conditions = app.process == "pHelm" ? ReadByConditions(reading) : Names{};
    for (const std::string& name : heard) {
      roles.Need(app.process, name, conditions.contains(name));
    }
  }
  roles.Tell(found);
  CheckImages(reading, has_image_reader, found);
  return problems;
}

}  // namespace limpet::internal
